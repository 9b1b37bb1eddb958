using System.Security.Cryptography;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Reads the program of a taken slot again: it was verified, and the piece cut next is assumed to be cut by it. A difference is
/// stored and reported as a trouble and in the audit trail. The report ends when the program is back or a person decides.</summary>
internal sealed class HeldProgram(CellFlow flow, MachineSettings machine, SlotSettings slot, ProgramSender sender)
{
    private const string Missing = "missing";
    private readonly string _where = CellTrouble.OfProgram(machine.Name, slot.Name);
    private (long Id, string? Program) _of;
    private long _readAt;
    private string? _told;

    /// <summary>True if the last read found another program in the slot.</summary>
    public bool IsChanged => _told is not null;

    /// <summary>The slot was just found to hold the right program.</summary>
    public void IsAsVerified(long id, string? program)
    {
        (_of, _readAt) = ((id, program), flow.Clock.GetTimestamp());
        End();
    }

    /// <summary>The slot is no longer held: someone decided.</summary>
    public void End()
    {
        _told = null;
        if (flow.Troubles.End(_where))
        {
            flow.Log.Information("{Where}: works again", _where);
        }
    }

    /// <summary>How long until the next read; zero if it has not been read yet.</summary>
    public TimeSpan Wait(long id, string? program) =>
        _of == (id, program) && flow.Clock.GetElapsedTime(_readAt) is var since && since < flow.Pace.Held
            ? flow.Pace.Held - since
            : TimeSpan.Zero;

    /// <summary>Reads the program.</summary>
    /// <returns>True if it is the right one.</returns>
    /// <exception cref="TransportException">It cannot be read.</exception>
    public async Task<bool> ReadAsync(Correction held, string? program, CancellationToken cancellation)
    {
        var found = await sender.CurrentAsync(slot.Program, cancellation);
        if (found is null)
        {
            // A process that had the right before, was frozen and went on may have set it aside, where a server has no other way.
            await sender.RecoverAsync(slot.Program, cancellation);
            found = await sender.CurrentAsync(slot.Program, cancellation);
        }

        var hash = found is null ? null : Convert.ToHexStringLower(SHA256.HashData(found));
        if (hash == program)
        {
            if (IsChanged)
            {
                flow.Store.Audit(CellFlow.ByCell, CellCodes.HeldAgain, Recorded.HeldAgain.With(slot.Program, machine.Name, held.Id),
                    Subject);
            }

            IsAsVerified(held.Id, program);
            return true;
        }

        var changed = Recorded.ChangedWhileHeld.With(slot.Program, machine.Name, held.Id, hash ?? Missing);
        if (_of.Id != held.Id || _told != (hash ?? Missing))
        {
            // Stored first: what a person changed there may be gone a moment later.
            flow.Store.Audit(CellFlow.ByCell, CellCodes.ChangedAtMachine, changed, Subject, found);
        }

        (_of, _readAt, _told) = ((held.Id, program), flow.Clock.GetTimestamp(), hash ?? Missing);
        if (flow.Troubles.Begin(_where, CellCodes.ChangedAtMachine, changed))
        {
            flow.Log.Warning("{Where}: {Code}: {Message}", _where, CellCodes.ChangedAtMachine, changed.Sentence);
        }

        return false;
    }

    private Statement Subject => Recorded.Slot.With(slot.Name, machine.Name);
}
