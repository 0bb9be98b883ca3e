{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>How far each candidate's curve lies from a reference, in per cent of the driving torque:</p>
<math display="block" tabindex="0"><mrow><mi>e</mi><mo>=</mo><mn>100</mn><mfrac><mrow><msub><mi>T</mi><mtext>f, candidate</mtext></msub><mo>−</mo><msub><mi>T</mi><mtext>f, reference</mtext></msub></mrow><mi>T</mi></mfrac><mspace width="0.3em"/><mtext>%</mtext></mrow></math>
<p>In a simulation the reference is the true curve. In a measurement it is half the difference between the two directions at the same angle, (<i>T</i>(+<i>ω</i>) − <i>T</i>(−<i>ω</i>))/2, which gravity does not affect: no prior knowledge is needed. It has an interval of its own: an error smaller than that is no evidence. It is the mean friction of both directions; where friction differs between them, every candidate is off by the asymmetry, (<i>T</i>(+<i>ω</i>) + <i>T</i>(−<i>ω</i>))/2 less gravity, which stage 8 shows.</p>
</div>
