{{%AUTOESCAPE context="HTML"}}
<section id="provenance" aria-labelledby="provenance-title">
<h2 id="provenance-title">Provenance <a class="self" href="#provenance" aria-label="Link to this section">#</a></h2>
<p>The same inputs, program and <code>SOURCE_DATE_EPOCH</code> give the same bytes again. Made {{CREATED:x-dates}} with:</p>
<pre class="command"><bdi>{{COMMAND_LINE}}</bdi></pre>
{{>TABLE}}
{{#INPUT_NOTES}}<h3 id="input-notes">Noticed while reading the input</h3>
<ul class="notes">
{{#INPUT_NOTE}}<li><bdi>{{TEXT}}</bdi></li>
{{/INPUT_NOTE}}</ul>{{/INPUT_NOTES}}
</section>
