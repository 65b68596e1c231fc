/* What a beginning of a word may become. */
:- module(test_complete, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(primitive/primitive), [primitive/1, primitive_form/2]).
:- use_module(rules(store)).
:- use_module(rules(studio/complete)).
:- use_module(rules(studio/world_state)).

names("predicate", "volume/2", "How large a solid is.").
names("request", "zz_fold", "Fold.").
names("request", "unzz_fold", "Unfold.").
names("request", Name, "One of many.") :-
    between(1, 60, N),
    format(string(Name), "many~d", [N]).

words(Text, World, Words, Left) :-
    completed(World, test_complete:names, _{text:Text}, Reply),
    _{words:Dicts, left:Left} :< Reply,
    findall(Name-Kind, ( member(Dict, Dicts),
                         _{word:Name, kind:Kind} :< Dict ), Words).

words(Text, Words) :-
    words(Text, none, Words, 0).

dict(Text, Dict) :-
    completed(none, test_complete:names, _{text:Text}, Reply),
    Reply.words = [Dict].

own(Text, Words) :-
    new_world(World),
    in_world(World,
             ( assert_fact(segment(12, solid, named(zzlid, box(size(1,1,1))))),
               assert_fact(param(zzwide, 7)) )),
    world_begun(World),
    completed(World, test_complete:names, _{text:Text}, Reply),
    world_forgotten(World),
    findall(Name-Kind-Doc, ( member(Dict, Reply.words),
                             _{word:Name, kind:Kind, doc:Doc} :< Dict ),
            Words).

:- begin_tests(complete).

%   What begins so comes before what has a word that does.
test(ranks, Words == ["zz_fold"-"request"]) :-
    words("zz", Words).
test(inner, Words == ["unzz_fold","zz_fold"]) :-
    completed(none, test_complete:names, _{text:"fold"}, Reply),
    findall(Name, ( member(Dict, Reply.words), get_dict(word, Dict, Name),
                    sub_string(Name, _, _, 0, "zz_fold") ), Words).
test(first_those_that_begin_so, Ranks == Sorted) :-
    completed(none, test_complete:names, _{text:"line"}, Reply),
    findall(Rank,
            ( member(Dict, Reply.words), get_dict(word, Dict, Name),
              ( sub_string(Name, 0, _, _, "line") -> Rank = 0 ; Rank = 1 ) ),
            Ranks),
    assertion(( memberchk(0, Ranks), memberchk(1, Ranks) )),
    msort(Ranks, Sorted).
test(capitals, Words == ["zz_fold"-"request"]) :-
    words("ZZ_f", Words).
test(meant, Words == ["zz_fold"-"request"]) :-
    words("zz_fodl", Words).
test(nothing, Words == []) :-
    words("qqqqqqqq", Words).
test(most, N-Left == 50-10) :-
    words("many", none, Words, Left),
    length(Words, N).
test(bad, [ forall(member(Head, [_{},_{text:5},_{text:null}])),
            error(request_error(bad_key(text, text)), _) ]) :-
    completed(none, test_complete:names, Head, _).
test(length, Whats == [none,bad_key(text, text)]) :-
    findall(What,
            ( member(N, [200,201]),
              length(Codes, N),
              maplist(=(0'q), Codes),
              string_codes(Text, Codes),
              catch(( completed(none, test_complete:names, _{text:Text}, _),
                      What = none ), error(request_error(What), _), true) ),
            Whats).
test(relation, Kind-Doc == "relation"-Doc0) :-
    dict("joint/6", Dict),
    _{kind:Kind, doc:Doc} :< Dict,
    relation(joint, 6, Doc0).
test(decision, Kind == "decision") :-
    dict("line_style/4", Dict),
    _{kind:Kind, doc:En, ko:Ko} :< Dict,
    assertion(korean(Ko)),
    assertion(\+ korean(En)).
test(primitives, [ forall(( primitive(Name0), atom_string(Name0, Name) )),
                   true(Found == Form-Name) ]) :-
    completed(none, test_complete:names, _{text:Name}, Reply),
    member(Dict, Reply.words),
    _{word:Name, kind:"primitive", doc:Doc, ko:Ko} :< Dict,
    !,
    primitive_form(Name0, Form0),
    atom_string(Form0, Form),
    assertion(( atom_string(Ko, Text), Text \== "" )),
    Found = Doc-Name.
test(predicate_in_korean) :-
    dict("volume/", Dict),
    _{kind:"predicate", doc:"How large a solid is.", ko:Ko} :< Dict,
    korean(Ko).
test(otherwise_as_it_is, Ko == "Fold.") :-
    dict("zz_fo", Dict),
    _{ko:Ko} :< Dict.
test(of_the_model, Words == [ "zz_fold"-"request"-"Fold.",
                              "zzlid"-"segment"-"s12, solid",
                              "zzwide"-"parameter"-"7" ]) :-
    own("zz", Words).
test(segment,
     Words == ["s12"-"segment"-"solid named(zzlid,box(size(1,1,1)))"]) :-
    own("s12", Words).

:- end_tests(complete).

korean(Text) :-
    string_codes(Text, Codes),
    member(Code, Codes),
    Code >= 0xac00,
    !.
