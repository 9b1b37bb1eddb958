using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>A verb that changes one user.</summary>
internal abstract class UserVerb : SigningVerb
{
    private readonly Argument<string> _name = new("NAME") { Description = "The user." };

    /// <summary>A verb with a user's name.</summary>
    protected UserVerb(string name, string description, string example, string lines = "the password of who signs")
        : base(name, description, example, lines) => Arguments.Add(_name);

    protected sealed override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation)
    {
        if (MayBeFirst)
        {
            StoreFolder.Make(settings);
        }
        else
        {
            DemandStore(settings);
        }

        return WithStore(settings, store => Run(new UserBook(store, TimeProvider.System), arguments.GetRequiredValue(_name), arguments));
    }

    /// <summary>True if the store need not exist yet.</summary>
    protected virtual bool MayBeFirst => false;

    /// <summary>Changes the user.</summary>
    protected abstract VerbResult Run(UserBook users, string name, ParseResult arguments);

    /// <summary>The answer for a changed user.</summary>
    protected UserAnswer Answer(User user, Func<User, string> sentence) => new($"errormatch/user-{Name}/1", user, sentence(user));
}
