{{%AUTOESCAPE context="HTML"}}
<section id="{{SECTION_ID}}" class="stage" aria-labelledby="{{SECTION_ID}}-title">
<h2 id="{{SECTION_ID}}-title"><span class="number">{{NUMBER}}</span> {{TITLE}} <span class="state {{OUTCOME}}">{{STATUS}}</span> <a class="self" href="#{{SECTION_ID}}" aria-label="Link to this section">#</a></h2>
{{>EXPLANATION}}
{{#REASON_IF}}<div class="remark {{OUTCOME}}"><p><bdi>{{REASON}}</bdi></p>{{#EXPERIMENT_IF}}<p class="experiment"><b>What would provide it:</b> {{EXPERIMENT}}</p>{{/EXPERIMENT_IF}}</div>{{/REASON_IF}}
{{#FACTS}}<dl class="facts">
{{#FACT}}<div><dt>{{NAME}}</dt><dd><bdi>{{TEXT:x-symbols}}</bdi></dd></div>
{{/FACT}}</dl>{{/FACTS}}
{{>REVIEW}}
{{>FIGURE}}
{{>TABLE}}
</section>
