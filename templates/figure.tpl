{{%AUTOESCAPE context="HTML"}}
<figure id="{{FIGURE_ID}}">
<h3>{{FIGURE_HEADING}} <a class="self" href="#{{FIGURE_ID}}" aria-label="Link to this figure">#</a></h3>
{{#PICTURE}}<div class="card"><img src="{{PNG:x-png}}" alt="{{ALT}}" width="{{WIDTH}}" height="{{HEIGHT}}" loading="{{LOADING}}" decoding="sync"></div>{{/PICTURE}}
{{#NO_PICTURE}}<div class="card no-picture" role="note"><p><b>This figure is missing.</b> <bdi>{{ERROR}}</bdi></p><p>It would show: <bdi>{{ALT}}</bdi></p></div>{{/NO_PICTURE}}
<figcaption>
{{#FIGURE_CAPTION_IF}}<p><bdi>{{FIGURE_CAPTION:x-symbols}}</bdi></p>{{/FIGURE_CAPTION_IF}}
{{#MORE}}<details class="how"><summary>How to read this</summary>
{{#HOW_TO_READ_IF}}<p><bdi>{{HOW_TO_READ:x-symbols}}</bdi></p>{{/HOW_TO_READ_IF}}
{{#DATA}}<p class="data"><a download="{{FILE}}" href="{{CSV:x-csv}}">Data of this figure <small>CSV, {{SIZE}}</small></a></p>
{{/DATA}}</details>{{/MORE}}{{#WARNING}}<p class="warning"><b>Drawn with a warning:</b> <bdi>{{TEXT}}</bdi></p>{{/WARNING}}
</figcaption>
</figure>
