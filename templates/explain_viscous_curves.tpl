{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>At constant speed the motor works against gravity and friction only. Each run is averaged over its plateau of constant speed; the share of gravity is subtracted, once for every candidate mass, eq. (11):</p>
<math display="block" tabindex="0"><mrow><msub><mi>T</mi><mi mathvariant="normal">f</mi></msub><mo>=</mo><mi>T</mi><mo>−</mo><mfrac><mrow><mi>m</mi><mi>g</mi><mi>r</mi></mrow><mi>n</mi></mfrac><mspace width="0.2em"/><mi>cos</mi><mspace width="0.15em"/><mo stretchy="false">(</mo><mi>q</mi><mo>−</mo><msub><mi>q</mi><mtext>peak</mtext></msub><mo stretchy="false">)</mo></mrow></math>
<p>Within a run friction is constant while the angle changes: one offset for each run and one cosine for all of them give gravity torque and its angle, without any sweep, if the travel is long enough.</p>
<p>A wrong mass lifts or lowers the whole curve: friction then looks larger in one direction than in the other.</p>
</div>
