{{%AUTOESCAPE context="HTML"}}
<section id="findings" aria-labelledby="findings-title">
<h2 id="findings-title">Findings, and what to record next <a class="self" href="#findings" aria-label="Link to this section">#</a></h2>
{{#FINDINGS}}<ol class="findings numbered">
{{#FINDING}}<li id="finding-{{NUMBER}}"><span class="ref">{{NUMBER}}</span> <bdi>{{TEXT}}</bdi>{{#CONSEQUENCE_IF}} <bdi>{{CONSEQUENCE}}</bdi>{{/CONSEQUENCE_IF}}{{#QUANTITIES_IF}} <small>{{QUANTITIES}}</small>{{/QUANTITIES_IF}}</li>
{{/FINDING}}</ol>
{{/FINDINGS}}{{#STEPS}}<h3 id="next-steps">What to record next</h3>
<ul class="steps">
{{#STEP}}<li><bdi>{{TEXT}}</bdi> <small>{{QUANTITIES}}</small></li>
{{/STEP}}</ul>
{{/STEPS}}{{#NOTES}}<details><summary>{{COUNT}}</summary>
<ol class="findings numbered">
{{#FINDING}}<li id="finding-{{NUMBER}}"><span class="ref">{{NUMBER}}</span> <bdi>{{TEXT}}</bdi></li>
{{/FINDING}}</ol>
</details>
{{/NOTES}}</section>
