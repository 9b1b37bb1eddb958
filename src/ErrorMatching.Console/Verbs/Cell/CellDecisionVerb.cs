using System.CommandLine;
using System.Globalization;
using System.Text.Json;
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

/// <summary><c>errormatch cell approve</c>.</summary>
internal sealed class CellApprove() : CellDecisionVerb(
    "approve",
    "Lets a correction that waits, or failed at its machine, go to the machine. A setter signs.",
    "errormatch cell approve samples/cell/cell.json 1 --user anna",
    needsReason: false)
{
    protected override Act Act => Act.Approve;

    protected override VerbResult Decide(
        CellSettings settings, CellStore store, long id, string by, string? reason, CancellationToken cancellation) =>
        new CellDecisionAnswer(
            "approve",
            new CorrectionDecisions(store).Approve(id, by, reason),
            "is approved and goes to its machine as soon as its slot is free");
}

/// <summary><c>errormatch cell reject</c>.</summary>
internal sealed class CellReject() : CellDecisionVerb(
    "reject",
    "Decides against a correction that is not at its machine. An operator signs.",
    "errormatch cell reject samples/cell/cell.json 1 --user anna --reason remeasured",
    needsReason: true)
{
    protected override Act Act => Act.Reject;

    protected override VerbResult Decide(
        CellSettings settings, CellStore store, long id, string by, string? reason, CancellationToken cancellation) =>
        new CellDecisionAnswer("reject", new CorrectionDecisions(store).Reject(id, by, reason!), "is rejected");
}

/// <summary><c>errormatch cell release</c>.</summary>
internal sealed class CellRelease() : CellDecisionVerb(
    "release",
    "Says that the piece is cut, which frees its slot for the next. An operator signs.",
    "errormatch cell release samples/cell/cell.json 1 --user anna",
    needsReason: false)
{
    protected override Act Act => Act.Release;

    protected override VerbResult Decide(CellSettings settings, CellStore store, long id, string by, string? reason,
        CancellationToken cancellation)
    {
        var secrets = new MachineSecrets(store, settings.KeysFolder);
        var release = new SlotRelease(settings, store, m => MachineFolders.Open(m, () => secrets.Get(m.Name)));
        var released = release.ReleaseAsync(id, by, reason, cancellation).GetAwaiter().GetResult();
        return new CellDecisionAnswer("release", released, "does not have its slot any more; the next in line may go");
    }
}

/// <summary><c>errormatch cell revert</c>.</summary>
internal sealed class CellRevert() : CellDecisionVerb(
    "revert",
    "Brings back the program that the slot held before a correction, or sends the one that takes its offset back, and reads it back. The "
        + "slot stays taken until cell release. A setter signs.",
    "errormatch cell revert samples/cell/cell.json 1 --user anna --reason chatter",
    needsReason: true)
{
    protected override Act Act => Act.Revert;

    protected override VerbResult Decide(
        CellSettings settings, CellStore store, long id, string by, string? reason, CancellationToken cancellation)
    {
        var secrets = new MachineSecrets(store, settings.KeysFolder);
        var reversal = new SlotReversal(settings, store, m => MachineFolders.Open(m, () => secrets.Get(m.Name)), TimeProvider.System);
        var reverted = reversal.RevertAsync(id, by, reason!, cancellation).GetAwaiter().GetResult();
        return new CellDecisionAnswer(
            "revert",
            reverted,
            reverted.UndoSha256 is null
                ? $"is reverted: {reverted.Machine} holds the program before it, read back. The slot stays taken until errormatch cell "
                    + "release"
                : $"is reverted: {reverted.Machine} holds the program that takes its offset back, read back. Run it there. The slot stays "
                    + "taken until errormatch cell release");
    }
}

/// <summary>A correction after a decision.</summary>
internal sealed class CellDecisionAnswer(string verb, Correction correction, string sentence) : DocumentAnswer
{
    public override string Schema => $"errormatch/cell-{verb}/1";

    public override void WriteJson(Utf8JsonWriter json) => CorrectionJson.WriteMembers(json, correction);

    public override void WriteText(Page page) =>
        page.Line($"Correction {correction.Id.ToString(CultureInfo.InvariantCulture)} ({correction.FileName}) {sentence}.");
}
