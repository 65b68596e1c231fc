:- module(sg_request,
          [ request_error/1,            % +What
            request_options/2,          % +Head, -Options
            of_owner/2                  % +Head, +What
          ]).
/** <module> What is wrong with a request, and its options.
*/

%!  request_error(+What) is failure.
%
%   @error request_error(What)

request_error(What) :-
    throw(error(request_error(What), _)).

%!  request_options(+Head:dict, -Options) is det.
%
%   Options are the words of a command line that Head has; none, if it has not.
%
%   @error request_error(bad_key(options, options))

request_options(Head, Options) :-
    (   get_dict(options, Head, Options0)
    ->  (   is_list(Options0)
        ->  Options = Options0
        ;   request_error(bad_key(options, options))
        )
    ;   Options = []
    ).

%!  of_owner(+Head:dict, +What) is det.
%
%   The request is the owner's.
%
%   @error request_error(owner_alone(What))

of_owner(Head, What) :-
    (   get_dict(owner, Head, true)
    ->  true
    ;   request_error(owner_alone(What))
    ).
