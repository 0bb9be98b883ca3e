{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>What was identified is taken as the truth: the model's torque is computed along the recorded motions, noise as seen in the recordings is added anew in each simulation, and the result goes through the same identification. A quantity that is not recovered cannot be found by this method on these motions at this noise, whatever its interval says.</p>
<p>The check cannot tell whether the model matches the joint: what the model lacks shows in the residuals and where independent estimates disagree.</p>
</div>
