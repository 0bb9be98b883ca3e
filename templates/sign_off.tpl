{{%AUTOESCAPE context="HTML"}}
<section id="sign-off" class="remark {{OUTCOME}}" aria-labelledby="sign-off-title">
<h2 id="sign-off-title">{{WORD}} <a class="self" href="#sign-off" aria-label="Link to this section">#</a></h2>
<p>{{DECISION}} by <bdi>{{REVIEWER}}</bdi>, {{AT}}.</p>
{{#NOTE}}<p><bdi>{{LINE}}</bdi></p>
{{/NOTE}}{{#EARLIER}}<details><summary>Earlier decisions: {{COUNT}}</summary>
<ol>
{{#REVIEW}}<li>{{DECISION}} by <bdi>{{REVIEWER}}</bdi>, {{AT}}.{{#NOTE}} <bdi>{{LINE}}</bdi>{{/NOTE}}</li>
{{/REVIEW}}</ol>
</details>
{{/EARLIER}}<p><small>Added to the report after it was made; the report's own text is unchanged. In the archive: <code>{{ID}}</code></small></p>
</section>
