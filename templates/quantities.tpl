{{%AUTOESCAPE context="HTML"}}
<section id="quantities" aria-label="Quantities">
<div class="table-box long" id="table-quantities" tabindex="0" role="region" aria-labelledby="table-quantities-caption">
<table class="judged summary">
<caption id="table-quantities-caption"><span>Results with expanded uncertainty, 95 %</span></caption>
<thead><tr><th scope="col">Quantity</th><th scope="col">{{SIDE}}</th>{{#JOINT_HEAD}}<th scope="col">At the joint</th>{{/JOINT_HEAD}}<th scope="col" class="number"><abbr title="coverage factor">k</abbr></th><th scope="col">Verdict</th>{{#CHANGES_HEAD}}<th scope="col">Since <span class="unit">{{DAY}}</span></th>{{/CHANGES_HEAD}}{{#PARTS_HEAD}}<th scope="col">Largest part of u²</th>{{/PARTS_HEAD}}</tr></thead>
<tbody>
{{#QUANTITY}}<tr class="{{OUTCOME}}"><th scope="row">{{WORDS}}</th><td class="value {{MOTOR_KIND}}" data-name="{{SIDE}}"><bdi>{{AT_MOTOR}}</bdi></td>{{#JOINT_SIDE}}<td class="{{JOINT_KIND}}" data-name="At the joint"><bdi>{{AT_JOINT}}</bdi></td>{{/JOINT_SIDE}}<td class="number {{COVERAGE_KIND}}" data-name="k">{{COVERAGE}}</td><td class="verdict-cell"><span class="state {{OUTCOME}}"><span aria-hidden="true">{{ICON}}</span> {{VERDICT}}</span>{{#REFERENCE}} <a class="ref" href="#finding-{{NUMBER}}"><span class="spoken">finding </span>{{NUMBER}}</a>{{/REFERENCE}}{{#LIMIT}} <span class="limit {{OUTCOME}}"><bdi>{{RULE}}</bdi> <span aria-hidden="true">{{ICON}}</span> {{WORD}}</span>{{/LIMIT}}</td>{{#CHANGE}}<td class="change {{KIND}}" data-name="Change"><bdi>{{AMOUNT}}</bdi>{{#RANGE_IF}} <small><bdi>{{RANGE}}</bdi></small>{{/RANGE_IF}}{{#WORD_IF}} <small class="word">{{WORD}}</small>{{/WORD_IF}}</td>{{/CHANGE}}{{#PART}}<td class="part {{PART_KIND}}" data-name="Largest part">{{LARGEST_PART}}</td>{{/PART}}</tr>
{{/QUANTITY}}</tbody>
</table>
</div>
{{#LIMITING_EFFECT_IF}}<p class="table-note limiting"><strong>What limits these numbers most:</strong> {{LIMITING_EFFECT}}</p>
{{/LIMITING_EFFECT_IF}}<p class="table-note">± U = k·u; where the 95 % interval is lopsided, its ends. {{#NOT_ASKED_FOR_IF}}{{NOT_ASKED_FOR}} {{/NOT_ASKED_FOR_IF}}{{#NO_LIMITS}}The manifest states no limits. {{/NO_LIMITS}}{{#NO_CHANGES}}There is no earlier calibration of this joint to compare with.{{/NO_CHANGES}}{{#CHANGES_NOTE}}Changes are relative to the calibration of {{DAY}}, <code>{{ID}}</code>; “changed” means more than chance over all quantities together.{{/CHANGES_NOTE}}</p>
</section>
