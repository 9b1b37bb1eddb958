using ErrorMatching.Cell;

namespace ErrorMatching.Console;

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
