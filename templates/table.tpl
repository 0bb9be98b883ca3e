{{%AUTOESCAPE context="HTML"}}
<div class="table-box" id="{{TABLE_ID}}" tabindex="0" role="region" aria-labelledby="{{TABLE_ID}}-caption">
<table class="{{TABLE_KIND}}">
<caption id="{{TABLE_ID}}-caption"><span>{{TABLE_CAPTION:x-symbols}}</span></caption>
<thead><tr>
{{#COLUMN}}<th scope="col" class="{{KIND}}">{{HEADING:x-symbols}}{{#UNIT_IF}} <span class="unit">[{{UNIT}}]</span>{{/UNIT_IF}}</th>
{{/COLUMN}}</tr></thead>
<tbody>
{{#ROW}}<tr class="{{ROW_KIND}}">{{#ROW_HEADING}}<th scope="row" class="{{KIND}}"><bdi>{{TEXT:x-symbols}}</bdi></th>{{/ROW_HEADING}}{{#CELL}}<td class="{{KIND}}"{{#NAME_IF}} data-name="{{NAME}}"{{/NAME_IF}}><bdi>{{TEXT:x-symbols}}</bdi></td>{{/CELL}}</tr>
{{/ROW}}</tbody>
</table>
</div>
{{#TABLE_NOTE_IF}}<p class="table-note"><bdi>{{TABLE_NOTE:x-symbols}}</bdi></p>{{/TABLE_NOTE_IF}}
