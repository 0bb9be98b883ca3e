{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>The paper takes the one of A to F whose curve has the smallest error. This program recommends the mid-line of the loop, which does not depend on the start-up stroke, or the sweep's gravity torque where there is no loop. For the paper's choice, eq. (14) corrects the angle of the centre of gravity by the angle from the peak at which the torque was read:</p>
<math display="block" tabindex="0"><mrow><msub><mi>q</mi><mtext>c, f</mtext></msub><mo>=</mo><msub><mi>q</mi><mi mathvariant="normal">c</mi></msub><mo>−</mo><mi>q</mi></mrow></math>
</div>
