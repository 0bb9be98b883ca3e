{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>Self-consistency: what was identified is taken as the truth. The model's torque is computed along the recorded motions, noise as seen in the recordings is added anew in each simulation, and the result goes through the same identification. A quantity that is not recovered cannot be found by this method on these motions at this noise, whatever its interval says. That it is recovered does not show that the model matches the joint: what the model lacks shows in the residuals and where independent estimates disagree.</p>
</div>
