using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>A verb that a person must sign: with name and password, for this command only.</summary>
internal abstract class SigningVerb : CellVerb
{
    /// <summary>The environment variable that names the signer if no option does. Passwords are never in a variable.</summary>
    public const string UserVariable = "ERRORMATCH_USER";

    private readonly Option<string> _user = new("--user")
    {
        Description = $"Who signs; without it, the environment's {UserVariable}.",
        HelpName = "NAME"
    };
    private readonly Option<bool> _fromInput;

    /// <summary>A verb with the options for signing.</summary>
    /// <param name="name">The word on the command line.</param>
    /// <param name="description">One sentence for the help.</param>
    /// <param name="example">A whole command line that works in the root of the checkout.</param>
    /// <param name="lines">What the lines of standard input are, in a word or two each.</param>
    protected SigningVerb(string name, string description, string example, string lines = "the password of who signs")
        : base(name, description, example)
    {
        _fromInput = new("--password-stdin")
        {
            Description = $"Read passwords from standard input instead of the keyboard, one a line: {lines}.",
            Arity = ArgumentArity.Zero
        };
        Options.Add(_user);
        Options.Add(_fromInput);
    }

    /// <summary>Prompts the signer for the password.</summary>
    /// <returns>The signature, valid for one act that must be signed, or several that need not be.</returns>
    /// <exception cref="PeopleException">As for <see cref="UserBook.SignIn"/>.</exception>
    protected SignedIn Sign(UserBook users, ParseResult arguments)
    {
        var name = arguments.GetValue(_user) ?? Environment.GetEnvironmentVariable(UserVariable);
        return string.IsNullOrEmpty(name)
            ? throw new SecretInputException($"It is not said who signs. Name --user or set {UserVariable}.")
            : users.SignIn(name, Secrets!.Ask($"password of {name}", arguments.GetValue(_fromInput)));
    }

    /// <summary>Prompts for a new password, twice at a keyboard.</summary>
    protected string AskNew(string prompt, ParseResult arguments) => Secrets!.AskNew(prompt, arguments.GetValue(_fromInput));
}
