{{%AUTOESCAPE context="HTML"}}
<div class="table-box" id="{{TABLE_ID}}" tabindex="0" role="region" aria-labelledby="{{TABLE_ID}}-caption">
<table class="checks">
<caption id="{{TABLE_ID}}-caption"><span>{{TABLE_CAPTION}}</span></caption>
<thead><tr><th scope="col">Check</th><th scope="col" class="number">Expected</th><th scope="col">Kind</th><th scope="col" class="number">tribolog</th><th scope="col">Unit</th><th scope="col" class="number">Difference</th><th scope="col" class="number">Allowed</th><th scope="col"></th></tr></thead>
<tbody>
{{#CHECK}}<tr class="{{STATE}}"><th scope="row"><bdi>{{WHAT:x-symbols}}</bdi>{{#REASON_IF}} <small>allowed: {{REASON:x-symbols}}</small>{{/REASON_IF}}</th><td class="number" data-name="expected">{{EXPECTED}}</td><td class="text" data-name="kind">{{KIND_OF_CHECK}}</td><td class="number" data-name="tribolog">{{OURS}}</td><td class="text unit">{{UNIT}}</td><td class="number" data-name="difference">{{DIFFERENCE}}</td><td class="number" data-name="allowed">{{ALLOWED}}</td><td class="tick">{{TICK}}</td></tr>
{{/CHECK}}</tbody>
</table>
</div>
