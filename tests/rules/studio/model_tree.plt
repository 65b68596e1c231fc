/* What a form shows of the text of a model. */
:- module(test_model_tree, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(http/json)).
:- use_module(rules(studio/model_tree)).

%   tree(Text, Key, Json): that part of the tree, as JSON reads it again.

tree(Text, Key, Part) :-
    text_tree(Text, Tree),
    atom_json_dict_text(Tree, Dict),
    get_dict(Key, Dict, Part).

atom_json_dict_text(Tree, Dict) :-
    with_output_to(string(Json), json_write_dict(current_output, Tree)),
    atom_json_dict(Json, Dict, [default_tag(json)]).

:- begin_tests(model_tree).

test(segments, Part == [ json{ segment:2, kind:"solid",
                               term:json{ name:"box",
                                          args:[json{name:"size",
                                                     args:[1,2.5,"x y"]}] } },
                         json{ segment:1, kind:"curve", term:"wire" },
                         json{ segment:3, kind:"solid",
                               term:json{ name:"union",
                                          args:[[1,2,[]]] } } ]) :-
    tree("segment(2, solid, box(size(1,2.5,'x y'))).\n\c
          segment(1, curve, wire).\nsegment(3, solid, union([1,2,[]])).\n\c
          v(1, 1, 0.0, 0.0, 0.0).\n", segments, Part).
test(params, Part == [ json{ param:"w", value:7,
                             about:json{ min:1, max:9.5, step:0.5, en:"wide",
                                         ko:"w" } },
                       json{ param:"h", value:json{ name:"*",
                                                    args:[2,json{name:"param",
                                                                 args:["w"]}]},
                             about:json{} } ]) :-
    tree("param(w, 7).\nparam(h, 2*param(w)).\n\c
          param_about(w, [min(1),max(9.5),step(0.5),text(en,\"wide\"),\c
          text(ko,\"w\")]).\nparam_about(h, [min(2*param(w)),other(1)]).\n",
         params, Part).
test(forms, Names == [box,cone]) :-
    text_tree("segment(1, solid, at([translate(1,2,3)], box(size(1,1,1)))).\n\c
               segment(2, solid, \c
               named(a, union([cone(radius(1),height(2))]))).",
              Tree),
    dict_keys(Tree.forms, Names),
    get_dict(box, Tree.forms, Box),
    dict_keys(Box, [size]).
test(words, Names == [box,size,translate]) :-
    text_tree("segment(1, solid, at([translate(1,2,3)], box(size(1,1,1)))).",
              Tree),
    dict_keys(Tree.words, Names).
test(no_words, Words-Forms == []-[]) :-
    text_tree("segment(1, solid, mesh).\n", Tree),
    dict_keys(Tree.words, Words),
    dict_keys(Tree.forms, Forms).
test(questions, Part == [ json{ name:"how many", goal:"p(1,P,_)" },
                          json{ name:"b", goal:"true" } ]) :-
    tree("question('how many', \"p(1,P,_)\").\nsegment(1, solid, mesh).\n\c
          question(b, true).\n", questions, Part).

:- end_tests(model_tree).

dict_keys(Dict, Keys) :-
    dict_pairs(Dict, _, Pairs),
    findall(Key, member(Key-_, Pairs), Keys).
