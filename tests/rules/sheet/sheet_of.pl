:- module(sheet_of,
          [ sheet_of/3                  % +File, +Options, -Drawing
          ]).
:- use_module(rules(command/sheet_options)).
:- use_module(rules(csg/csg_roots), [operand_lines/1, roots_alone/0]).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(penetration/penetration), [penetrate/2]).
:- use_module(rules(sheet/sheet_plan), [views_drawing/5]).
:- use_module(rules(store)).

%!  sheet_of(+File, +Options, -Drawing) is det.
%
%   The Drawing of the model File by Options as on the command line.

sheet_of(File, Options, Drawing) :-
    sheet_request(Options, [lines(feature)], Request0),
    new_world(World),
    in_world(World,
             ( load_model(File),
               request_facts(Options, [File], Request0, Request),
               operand_lines(Lines),
               roots_alone,
               views_drawing(Request, Lines, sheet_of:cuts(cut, cut),
                             Drawing, _) )).

cut :-
    findall(S, segment(S, _, _), Ss),
    (   Ss = [_,_|_]
    ->  penetrate(all, [])
    ;   true
    ).
