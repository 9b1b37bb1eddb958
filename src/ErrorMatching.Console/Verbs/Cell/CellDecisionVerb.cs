using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>A verb by which a person signs a decision about a correction.</summary>
internal abstract class CellDecisionVerb : SigningVerb
{
    private readonly IdArgument _id = new();
    private readonly Option<string> _reason;

    /// <param name="name">The word on the command line.</param>
    /// <param name="description">One sentence for the help.</param>
    /// <param name="example">A whole command line.</param>
    /// <param name="needsReason">True if the decision requires a reason.</param>
    protected CellDecisionVerb(string name, string description, string example, bool needsReason)
        : base(name, description, example)
    {
        _reason = new("--reason") { Description = "Why, for the audit trail.", HelpName = "TEXT", Required = needsReason };
        _reason.Validators.Add(result =>
        {
            if (result.Tokens is [var token] && string.IsNullOrWhiteSpace(token.Value))
            {
                result.AddError("--reason is empty; expected why.");
            }
        });
        Arguments.Add(_id);
        Options.Add(_reason);
    }

    protected sealed override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation) =>
        WithExistingStore(settings, store =>
    {
        var users = new UserBook(store, TimeProvider.System);
        var by = Sign(users, arguments);
        users.Demand(by, Act);
        return Decide(settings, store, arguments.GetRequiredValue(_id), by.Name, arguments.GetValue(_reason), cancellation);
    });

    /// <summary>The right that the signer must have. Not a field: a field of one of the cell's types would load its library with the
    /// command line.</summary>
    protected abstract Act Act { get; }

    /// <summary>Carries out the decision.</summary>
    protected abstract VerbResult Decide(
        CellSettings settings, CellStore store, long id, string by, string? reason, CancellationToken cancellation);
}
