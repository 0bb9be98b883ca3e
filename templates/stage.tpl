{{%AUTOESCAPE context="HTML"}}
<section id="{{SECTION_ID}}" class="{{EXTENT}}" aria-labelledby="{{SECTION_ID}}-title">
<h2 id="{{SECTION_ID}}-title"><span class="number">{{NUMBER}}</span> {{TITLE}} <span class="state {{OUTCOME}}">{{STATUS}}</span>{{#REFERENCE}} <a class="ref" href="#finding-{{NUMBER}}"><span class="spoken">finding </span>{{NUMBER}}</a>{{/REFERENCE}} <a class="self" href="#{{SECTION_ID}}" aria-label="Link to this section">#</a></h2>
{{#REASON_IF}}<div class="remark {{OUTCOME}}"><p><bdi>{{REASON}}</bdi></p></div>{{/REASON_IF}}
{{>REVIEW}}
{{>FIGURE}}
{{#FOLD}}<details class="fold"><summary>{{WHAT}}</summary>
{{#EXPERIMENT_IF}}<p class="experiment"><b>What would provide it:</b> {{EXPERIMENT}}</p>{{/EXPERIMENT_IF}}
{{>EXPLANATION}}
{{#FACTS}}<dl class="facts">
{{#FACT}}<div><dt>{{NAME}}</dt><dd><bdi>{{TEXT:x-symbols}}</bdi></dd></div>
{{/FACT}}</dl>{{/FACTS}}
{{>TABLE}}
{{>FOLDED_FIGURE}}
</details>{{/FOLD}}
</section>
