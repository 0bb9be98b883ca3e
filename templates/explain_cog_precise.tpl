{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>The same within about ±1° of the rough result, slower. So close to the peak the torque is flat: the angle can be read better, but the size of gravity hardly shows. The fit therefore takes the gravity torque <i>G</i>/<i>n</i> from the rough sweep, where there is one, and estimates only the angle:</p>
<math display="block" tabindex="0"><mrow><mi>T</mi><mo>=</mo><msub><mi>T</mi><mi mathvariant="normal">f</mi></msub><mo>+</mo><mfrac><mi>G</mi><mi>n</mi></mfrac><mspace width="0.2em"/><mi>cos</mi><mspace width="0.15em"/><mo stretchy="false">(</mo><mi>q</mi><mo>−</mo><msub><mi>q</mi><mtext>peak</mtext></msub><mo stretchy="false">)</mo></mrow></math>
</div>
