{{%AUTOESCAPE context="HTML"}}
<div class="table-box" id="{{TABLE_ID}}" tabindex="0" role="region" aria-labelledby="{{TABLE_ID}}-caption">
<table>
<caption id="{{TABLE_ID}}-caption"><span>{{TABLE_CAPTION}}</span></caption>
<thead><tr>
{{#COLUMN}}<th scope="col" class="{{KIND}}">{{HEADING}}{{#UNIT_IF}} <span class="unit">[{{UNIT}}]</span>{{/UNIT_IF}}</th>
{{/COLUMN}}</tr></thead>
<tbody>
{{#ROW}}<tr class="{{ROW_KIND}}">{{#ROW_HEADING}}<th scope="row" class="{{KIND}}"><bdi>{{TEXT}}</bdi></th>{{/ROW_HEADING}}{{#CELL}}<td class="{{KIND}}"><bdi>{{TEXT}}</bdi></td>{{/CELL}}</tr>
{{/ROW}}</tbody>
</table>
</div>
{{#TABLE_NOTE_IF}}<p class="table-note"><bdi>{{TABLE_NOTE}}</bdi></p>{{/TABLE_NOTE_IF}}
