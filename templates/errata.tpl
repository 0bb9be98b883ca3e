{{%AUTOESCAPE context="HTML"}}
<section id="errata" aria-labelledby="errata-title">
<h2 id="errata-title">Errata of the paper <a class="self" href="#errata" aria-label="Link to this section">#</a></h2>
<p>The method is that of “Viscous friction measurement technique in robot joint with the use of surrogate mass”. Its text has misprints; this program follows the corrected form. The evidence is computed from the paper's own table 2 when this report is made.</p>
<div class="table-box" id="table-errata" tabindex="0" role="region" aria-labelledby="table-errata-caption">
<table class="errata">
<caption id="table-errata-caption"><span>What is printed, what is meant, and what shows it</span></caption>
<thead><tr><th scope="col">Where</th><th scope="col">Printed</th><th scope="col">Meant</th><th scope="col">Evidence</th></tr></thead>
<tbody>
<tr><th scope="row">3.3, <i>r</i><sub>REPL</sub></th><td>500 m</td><td>0.500 m, i.e. 500 mm</td><td>Row A, {{TORQUE_A}} N·m: 0.5 m gives {{MASS_A_500_MM}} kg against {{MASS_A_PRINTED}} kg printed; 500 m gives {{MASS_A_500_M}} kg.</td></tr>
<tr><th scope="row">eq. (12), <i>n</i></th><td><i>n</i> in the denominator</td><td><math><mrow><mi>m</mi><mo>=</mo><mfrac><mrow><mi>n</mi><msub><mi>T</mi><mi mathvariant="normal">d</mi></msub></mrow><mrow><mi>g</mi><mi>r</mi><mspace width="0.2em"/><mi>cos</mi><mspace width="0.15em"/><mo stretchy="false">(</mo><mi>q</mi><mo>−</mo><msub><mi>q</mi><mtext>peak</mtext></msub><mo stretchy="false">)</mo></mrow></mfrac></mrow></math> with <i>T</i><sub>d</sub> at the motor</td><td>All six rows of table 2 agree within {{LARGEST_DEVIATION}} kg; rounding of the printed figures allows {{ALLOWED_DEVIATION}} kg. With <i>n</i> below, row A would be {{MASS_A_N_BELOW}} kg, or {{MASS_A_ARM_N_BELOW}} kg from the torque at the arm.</td></tr>
<tr><th scope="row">eq. (12), cosine</th><td>cos(<i>q</i><sub>c</sub>), <i>q</i><sub>c</sub> = 22.23°</td><td>cosine of the angle away from the peak, about 1</td><td>cos 22.23187° = {{COS_Q_C}} would make row A {{MASS_A_COS_Q_C}} kg; printed are {{MASS_A_PRINTED}} kg.</td></tr>
<tr><th scope="row">3.2, sign and digits of <i>q</i><sub>c</sub></th><td>−22° = 0.383 rad; −22.23187° = 0.38801 rad</td><td>the joint angle <i>q</i><sub>peak</sub> is negative, the link angle <i>q</i><sub>c</sub> = −<i>q</i><sub>peak</sub> positive</td><td>22° = {{RAD_OF_22}} rad (printed value {{CUT_OF_22}}, not rounded); 22.23187° = {{RAD_OF_PRECISE}} rad (printed value {{CUT_OF_PRECISE}}, not rounded).</td></tr>
<tr><th scope="row">table 1</th><td>σ<sub>0</sub> = 1·10<sup>−5</sup> N/m, σ<sub>1</sub> = 1·10<sup>−10</sup> N·s/m</td><td>σ<sub>0</sub> = 10<sup>5</sup> N/m, σ<sub>1</sub> = √10<sup>5</sup> ≈ {{DAMPING_MEANT}}</td><td>The static force 1.5 N would need {{DEFLECTION_PRINTED}} of bristle deflection instead of {{DEFLECTION_MEANT}}. Canudas de Wit et al. 1995, table 1.</td></tr>
<tr><th scope="row">eq. (1)</th><td>sgn(ω) on a line of its own</td><td>it multiplies the whole expression</td><td>Friction is odd in ω.</td></tr>
<tr><th scope="row">eq. (2)</th><td>|ω| ≥ ω<sub>th</sub> in both branches</td><td>|ω| &lt; ω<sub>th</sub> in the second</td><td>As printed nothing is defined below ω<sub>th</sub>; as meant the branches meet at ω<sub>th</sub>.</td></tr>
<tr><th scope="row">eq. (6)</th><td>exponents and dots lost in print</td><td><math><mrow><msub><mi>T</mi><mi mathvariant="normal">a</mi></msub><msup><mi>e</mi><mrow><mo>−</mo><msup><mrow><mo stretchy="false">(</mo><mi>ω</mi><mo>/</mo><msub><mi>ω</mi><mi mathvariant="normal">s</mi></msub><mo stretchy="false">)</mo></mrow><msub><mi>δ</mi><mi mathvariant="normal">a</mi></msub></msup></mrow></msup><mo>+</mo><msub><mi>c</mi><mi mathvariant="normal">v</mi></msub><msup><mi>ω</mi><mrow><mn>1</mn><mo>−</mo><msub><mi>δ</mi><mi mathvariant="normal">v</mi></msub></mrow></msup></mrow></math>, ω ≥ 0</td><td>Waiboer, Aarts and Jonker 2005.</td></tr>
</tbody>
</table>
</div>
<h3 id="pair-means">What the paper's table does not say</h3>
<p>The six printed masses differ by {{SINGLE_SPREAD}} kg. The means of opposite points, (A + B)/2, (C + D)/2 and (E + F)/2 of the same table, are {{PAIR_MASSES}} kg: they differ by {{PAIR_SPREAD}} kg only. In a steady loop opposite points lie on either side of the true value, so the choice among A to F rests on the start-up stroke, and the pair means and the mid-line do not.</p>
{{#TABLE_ABOVE}}<p>Table 2 recomputed, with the masses of this dataset beside it, is in <a href="#table-paper-2">stage 4</a>.</p>{{/TABLE_ABOVE}}
{{>TABLE}}
</section>
