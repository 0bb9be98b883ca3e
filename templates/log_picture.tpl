{{%AUTOESCAPE context="HTML"}}
<figure class="log-picture">
<svg viewBox="0 0 1000 132" role="img" aria-label="{{CAPTION}} {{NAMES}}">
{{#PHASE}}<g class="{{ROLE}}"><rect x="{{FROM}}" y="18" width="{{WIDTH}}" height="112"/><path d="{{PATH}}"/>{{#NAMED}}<text x="{{MIDDLE}}" y="12">{{NAME}}</text>{{/NAMED}}</g>
{{/PHASE}}<g class="y-ticks">{{#Y_TICK}}<text x="59" y="{{AT}}" dy="4">{{LABEL}}</text>{{/Y_TICK}}</g>
</svg>
<figcaption>{{CAPTION}}</figcaption>
</figure>
