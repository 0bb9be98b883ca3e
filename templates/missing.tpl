{{%AUTOESCAPE context="HTML"}}
<section id="missing" aria-labelledby="missing-title">
<h2 id="missing-title">What is missing, and why <a class="self" href="#missing" aria-label="Link to this section">#</a></h2>
<dl class="missing">
{{#ITEM}}<dt><a href="#{{SECTION_ID}}">{{STAGE_NAME}}</a></dt>
<dd><bdi>{{REASON}}</bdi>{{#EXPERIMENT_IF}}<p class="experiment"><b>What would provide it:</b> {{EXPERIMENT}}</p>{{/EXPERIMENT_IF}}</dd>
{{/ITEM}}
</dl>
</section>
