{{%AUTOESCAPE context="HTML"}}
<div class="key-picture" id="{{PICTURE_ID}}">
<h3>{{TITLE}}</h3>
<svg viewBox="0 0 440 250" role="img" aria-label="{{TITLE}}: {{Y_TITLE}}, {{X_TITLE}}. {{CAPTION}}">
<path class="grid" d="{{GRID}}"/>
{{#PATH}}<path class="{{KIND}}" d="{{PATH}}"/>
{{/PATH}}<path class="frame" d="M56 8H432V206H56Z"/>
<g class="x-ticks">{{#X_TICK}}<text x="{{AT}}" y="221">{{LABEL}}</text>{{/X_TICK}}</g>
<g class="y-ticks">{{#Y_TICK}}<text x="51" y="{{AT}}" dy="4">{{LABEL}}</text>{{/Y_TICK}}</g>
<text class="title" x="244" y="243">{{X_TITLE}}</text>
<text class="title" transform="translate(13 107) rotate(-90)">{{Y_TITLE}}</text>
</svg>
<p>{{CAPTION}}</p>
</div>
