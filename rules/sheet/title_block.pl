:- module(sg_title_block,
          [ title_block_read/2          % +File, -Items
          ]).
:- use_module('../model/model_text',
              [next_fact/3, place_error/2]).
:- use_module('../text_file', [with_text/4]).
:- use_module(library(lists), [memberchk/2]).
/** <module> A file of facts for the title block.

It is data, as a model file: title_block/2 facts and nothing else. The same
facts may stand in a model file.
*/

%!  title_block_read(+File, -Items) is det.
%
%   Items, a list of Item-Text, are what File (`-`: standard input) holds.
%
%   @error model_error(What): those of model_text.pl; twice(title_block,Item);
%   title_block_only(Name)

title_block_read(File, Items) :-
    with_text(facts, File, Text, items_read(Text, [], Items)).

items_read(Text, Known, Items) :-
    next_fact(Text, Fact, Place),
    (   Fact == end_of_file
    ->  Items = []
    ;   Fact = title_block(Item, Value)
    ->  (   memberchk(Item, Known)
        ->  place_error(Place, twice(title_block, Item))
        ;   true
        ),
        Items = [Item-Value|Items1],
        items_read(Text, [Item|Known], Items1)
    ;   functor(Fact, Name, _),
        place_error(Place, title_block_only(Name))
    ).
