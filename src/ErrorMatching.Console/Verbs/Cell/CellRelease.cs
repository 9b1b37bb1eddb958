using ErrorMatching.Cell;

namespace ErrorMatching.Console;

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
