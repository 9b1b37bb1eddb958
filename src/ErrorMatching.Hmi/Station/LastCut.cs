using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>The last cut with a free slot's program.</summary>
/// <param name="Correction">The released correction.</param>
/// <param name="IsMating">True if its piece has a counterpart that can be verified.</param>
/// <param name="Counterpart">The last measurement of its counterpart; null if there is none.</param>
public sealed record LastCut(Correction Correction, bool IsMating, Correction? Counterpart)
{
    // How many corrections of a machine are searched: no machine has more slots in rotation.
    private const int Looked = 20;

    /// <summary>Finds the last cut with a slot's program.</summary>
    /// <returns>The last cut; null if the slot is occupied, or if the origin of its program is unknown.</returns>
    /// <param name="settings">The cell's configuration.</param>
    /// <param name="store">The store.</param>
    /// <param name="slot">The slot.</param>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    public static LastCut? Of(CellSettings settings, CellStore store, SlotStatus slot)
    {
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(store);
        ArgumentNullException.ThrowIfNull(slot);
        if (slot is not { Held: null, Holding.ProgramSha256: { } program }
            || Last(CorrectionState.Released) is not { } cut
                || cut.ProgramSha256 != program
                || Last(CorrectionState.Reverted)?.ChangedAt > cut.ChangedAt)
        {
            return null;
        }

        var mating = MatingChoice.Of(settings).FirstOrDefault(m => m.Jobs.Contains(cut.Job, StringComparer.Ordinal));
        return new(
            cut,
            mating is not null,
            mating is null ? null : store.Corrections.Reported(mating.Jobs, StoredPieces.Most).FirstOrDefault(c => IsOf(c, cut)));

        Correction? Last(CorrectionState state) => store.Search(new() { Machine = slot.Machine.Name, State = state, Most = Looked })
            .Where(c => c.Slot == slot.Slot.Name)
            .MaxBy(c => c.ChangedAt);
    }

    private static bool IsOf(Correction counterpart, Correction cut) =>
        counterpart is { Piece: PieceWords.Counterpart, PartSha256: not null }
            && !counterpart.IsSetAside
            && counterpart.PartSha256 == cut.MeasurementSha256;
}
