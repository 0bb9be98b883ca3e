{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>What was identified is put in as the truth: the model's torque is computed along the recorded motions, the noise that the recordings show is laid on it anew in each simulation, and the result goes through the same identification. A quantity that does not come back cannot be found by this method on these motions at this noise, whatever its interval says.</p>
<p>The check cannot tell whether the model is the joint's: what the model lacks shows in the residuals and where independent estimates disagree.</p>
</div>
