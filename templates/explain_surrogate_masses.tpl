{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>A surrogate mass is a point mass at a freely chosen distance <i>r</i> from the axis that loads the joint as the real arm does. Each torque <i>T</i> read at the motor, taken for gravity alone, gives one by eq. (12) of the paper in its corrected form:</p>
<math display="block" tabindex="0"><mrow><mi>m</mi><mo>=</mo><mfrac><mrow><mi>n</mi><mi>T</mi></mrow><mrow><mi>g</mi><mi>r</mi><mspace width="0.2em"/><mi>cos</mi><mspace width="0.15em"/><mo stretchy="false">(</mo><mi>q</mi><mo>−</mo><msub><mi>q</mi><mtext>peak</mtext></msub><mo stretchy="false">)</mo></mrow></mfrac></mrow></math>
<p>A to F are the paper's six. In a steady loop A and B lie on either side of the true value by the same amount, as do C and D, E and F: their means, and the mid-line of the loop, cancel friction; the single points do not.</p>
</div>
