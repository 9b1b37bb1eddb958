using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>The option for a role.</summary>
internal sealed class RoleOption : Option<string>
{
    // Not taken from the enumeration: building the command line must not load the cell's library. A test checks that they agree.
    internal static readonly string[] Words = ["operator", "setter", "administrator"];

    public RoleOption()
        : base("--role")
    {
        Description = "operator (sees, releases, rejects), setter (approves, reverts, edits jobs too) or administrator (users, machines "
            + "and policy too).";
        HelpName = "ROLE";
        Required = true;
        CompletionSources.Add(Words);
        Validators.Add(result =>
        {
            if (result.Tokens is [{ Value: var word }] && !Words.Contains(word))
            {
                result.AddError($"The role is {word}; expected {string.Join(", ", Words)}.");
            }
        });
    }

    /// <summary>The selected role.</summary>
    public Role Of(ParseResult arguments) => (Role)Array.IndexOf(Words, arguments.GetRequiredValue(this));

    /// <summary>The word for a role.</summary>
    public static string Word(Role role) => Words[(int)role];
}
