{{%AUTOESCAPE context="HTML"}}
<section id="quantities" aria-labelledby="quantities-title">
<h2 id="quantities-title">Verdict on each quantity <a class="self" href="#quantities" aria-label="Link to this section">#</a></h2>
<div class="table-box long" id="table-quantities" tabindex="0" role="region" aria-labelledby="table-quantities-caption">
<table class="judged">
<caption id="table-quantities-caption"><span>What can be used, and what to record next (torques at the motor)</span></caption>
<thead><tr><th scope="col">Quantity</th><th scope="col">Verdict</th><th scope="col">Estimate, 95 % interval</th><th scope="col">Why, and what to record next</th></tr></thead>
<tbody>
{{#QUANTITY}}<tr><th scope="row">{{WORDS}}</th><td><span class="state {{OUTCOME}}"><span aria-hidden="true">{{ICON}}</span> {{VERDICT}}</span></td><td data-name="Estimate"><bdi>{{ESTIMATE}}</bdi></td><td class="words">{{#REASON}}<p><bdi>{{TEXT}}</bdi></p>{{/REASON}}{{#FURTHER}}<details><summary>{{COUNT}}</summary>{{#REASON}}<p><bdi>{{TEXT}}</bdi></p>{{/REASON}}</details>{{/FURTHER}}{{#LIMIT}}<p><bdi>{{TEXT}}</bdi></p>{{/LIMIT}}{{#EXPERIMENT_IF}}<p class="next"><b>Next:</b> <bdi>{{EXPERIMENT}}</bdi></p>{{/EXPERIMENT_IF}}{{#FINE}}–{{/FINE}}</td></tr>
{{/QUANTITY}}</tbody>
</table>
</div>
</section>
