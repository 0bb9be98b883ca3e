{{%AUTOESCAPE context="HTML"}}
<div class="paper-item" id="{{ITEM_ID}}">
{{#HEADING_IF}}<h3>{{HEADING}} <a class="self" href="#{{ITEM_ID}}" aria-label="Link to this item">#</a></h3>{{/HEADING_IF}}
{{>EQUATION}}
{{>FIGURE}}
{{>TABLE}}
{{#REMARK_IF}}<p class="remark partial">{{REMARK:x-symbols}}</p>{{/REMARK_IF}}
{{#FOLD}}<details class="fold"><summary>{{WHAT}}</summary>
{{>DETAILS}}
</details>{{/FOLD}}
{{>DETAILS}}
</div>
