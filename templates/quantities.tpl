{{%AUTOESCAPE context="HTML"}}
<section id="quantities" aria-labelledby="quantities-title">
<h2 id="quantities-title">Quantities <a class="self" href="#quantities" aria-label="Link to this section">#</a></h2>
<div class="table-box long" id="table-quantities" tabindex="0" role="region" aria-labelledby="table-quantities-caption">
<table class="judged summary">
<caption id="table-quantities-caption"><span>Results, torques at the motor</span></caption>
<thead><tr><th scope="col">Quantity</th><th scope="col">Verdict</th><th scope="col" class="number">Estimate</th><th scope="col" class="number">95 % interval</th>{{#LIMITS_HEAD}}<th scope="col">Limit</th>{{/LIMITS_HEAD}}{{#CHANGES_HEAD}}<th scope="col">Since <span class="unit">{{DAY}}</span></th>{{/CHANGES_HEAD}}</tr></thead>
<tbody>
{{#QUANTITY}}<tr><th scope="row">{{WORDS}}</th><td><span class="state {{OUTCOME}}"><span aria-hidden="true">{{ICON}}</span> {{VERDICT}}</span></td><td class="number value{{#NO_ESTIMATE}} none{{/NO_ESTIMATE}}" data-name="Estimate"><bdi>{{ESTIMATE}}</bdi></td><td class="number{{#NO_INTERVAL}} none{{/NO_INTERVAL}}" data-name="95 % interval"><bdi>{{INTERVAL}}</bdi></td>{{#LIMITS}}<td class="limits{{#NONE}} none{{/NONE}}" data-name="Limit">{{#LIMIT}}<span class="limit {{OUTCOME}}"><bdi>{{RULE}}</bdi> <span aria-hidden="true">{{ICON}}</span> {{WORD}}</span>{{/LIMIT}}{{#NONE}}–{{/NONE}}</td>{{/LIMITS}}{{#CHANGE}}<td class="change {{KIND}}" data-name="Change"><bdi>{{AMOUNT}}</bdi>{{#RANGE_IF}} <small><bdi>{{RANGE}}</bdi></small>{{/RANGE_IF}}{{#WORD_IF}} <small class="word">{{WORD}}</small>{{/WORD_IF}}</td>{{/CHANGE}}</tr>
{{#WHY}}<tr class="why"><td colspan="{{COLUMNS}}">{{#REASON}}<p><bdi>{{TEXT}}</bdi></p>{{/REASON}}{{#FURTHER}}<details><summary>{{COUNT}}</summary>{{#REASON}}<p><bdi>{{TEXT}}</bdi></p>{{/REASON}}</details>{{/FURTHER}}{{#EXPERIMENT_IF}}<p class="next"><b>Next:</b> <bdi>{{EXPERIMENT}}</bdi></p>{{/EXPERIMENT_IF}}</td></tr>
{{/WHY}}{{/QUANTITY}}</tbody>
</table>
</div>
<p class="table-note">{{#NO_LIMITS}}The manifest states no limits. {{/NO_LIMITS}}{{#NO_CHANGES}}There is no earlier calibration of this joint to compare with.{{/NO_CHANGES}}{{#CHANGES_NOTE}}Changes are relative to the calibration of {{DAY}}, <code>{{ID}}</code>; “changed” means more than chance over all quantities together.{{/CHANGES_NOTE}}</p>
</section>
