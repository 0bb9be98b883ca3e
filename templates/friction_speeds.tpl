{{%AUTOESCAPE context="HTML"}}
<section id="friction-at-speed">
<h3>Friction at speed</h3>
<div class="table-box" id="table-friction-at-speed" tabindex="0" role="region" aria-label="Friction at speed">
<table class="friction-speeds">
<thead><tr><th scope="col">{{SPEED}} <span class="unit">[rad/s]</span></th>{{#JOINT_HEAD}}<th scope="col">Joint speed <span class="unit">[rad/s]</span></th>{{/JOINT_HEAD}}<th scope="col">{{SIDE}} <span class="unit">[{{UNIT}}]</span></th>{{#JOINT_HEAD}}<th scope="col">At the joint <span class="unit">[{{UNIT_AT_JOINT}}]</span></th>{{/JOINT_HEAD}}<th scope="col"><span class="spoken">Verdict</span></th></tr></thead>
<tbody>
{{#SPEED}}<tr><th scope="row">{{MOTOR_SPEED}}</th>{{#JOINT_SIDE}}<td>{{JOINT_SPEED}}</td>{{/JOINT_SIDE}}<td><bdi>{{AT_MOTOR}}</bdi></td>{{#JOINT_SIDE}}<td><bdi>{{AT_JOINT}}</bdi></td>{{/JOINT_SIDE}}<td><span class="state {{OUTCOME}}" title="{{VERDICT}}"><span aria-hidden="true">{{ICON}}</span><span class="spoken">{{VERDICT}}</span></span></td></tr>
{{/SPEED}}</tbody>
</table>
</div>
<p class="table-note"><bdi>{{GOOD_FOR}}</bdi></p>
</section>
