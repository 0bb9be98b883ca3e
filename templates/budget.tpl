{{%AUTOESCAPE context="HTML"}}
{{#RECORDINGS_ALONE}}<p>Each uncertainty comes from the recordings alone (type A: noise, ripple, the choice of the model); U and k stand on page one. What no recording shows is added by the manifest, for example:</p>
<pre class="command">[uncertainty]
torque_constant_percent = 2
gear_ratio_percent = 0.1
surrogate_distance_percent = 0.1</pre>
{{#HAS_EFFECTS}}<p>What most of u² would go with, if its size were known (the manifest's <code>[effects]</code> can state it); effects that look alike overlap:</p>
<ul>
{{#EFFECTS_OF}}<li>{{QUANTITY}}: {{EFFECTS}}</li>
{{/EFFECTS_OF}}</ul>{{/HAS_EFFECTS}}{{/RECORDINGS_ALONE}}{{#PARTS_TABLE}}<div class="table-box" id="table-budget" tabindex="0" role="region" aria-labelledby="table-budget-caption">
<table class="judged budget">
<caption id="table-budget-caption"><span>Uncertainty of each quantity, at the motor, and what it is made of</span></caption>
<thead><tr><th scope="col">Quantity</th><th scope="col" class="number">u</th><th scope="col" class="number"><abbr title="effective degrees of freedom">ν</abbr></th><th scope="col" class="number">k</th><th scope="col" class="number">U, 95 %</th><th scope="col">Parts of u²</th></tr></thead>
<tbody>
{{#ROW}}<tr><th scope="row">{{QUANTITY}}</th><td class="number" data-name="u">{{STANDARD}}</td><td class="number" data-name="ν">{{FREEDOM}}</td><td class="number" data-name="k">{{COVERAGE}}</td><td class="number" data-name="U">{{EXPANDED}}</td><td class="parts"><svg class="bar" viewBox="0 0 100 6" preserveAspectRatio="none" aria-hidden="true">{{#BAR}}<rect class="{{KIND}}" x="{{FROM}}" y="0" width="{{WIDTH}}" height="6"/>{{/BAR}}</svg>{{#PART}}<span class="part-name {{KIND}}">{{NAME}}</span> {{/PART}}{{#NO_PARTS}}–{{/NO_PARTS}}{{#EFFECTS_IF}}<small>of A: {{EFFECTS}}</small>{{/EFFECTS_IF}}</td></tr>
{{/ROW}}</tbody>
</table>
</div>
<p class="table-note">After JCGM 100 (GUM). A: from the recordings, with noise, ripple and the choice of the model. B: from the manifest's [uncertainty]. Of A: what would go of it if the size of the effect were known (the manifest's [effects] can state it); effects that look alike overlap. ν by Welch and Satterthwaite; ∞ where the stage does not state it.</p>{{/PARTS_TABLE}}
