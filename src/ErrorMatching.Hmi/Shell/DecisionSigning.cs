using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Asks for the signature to approve or reject a correction: what is signed is what the screen shows behind the dialog.</summary>
internal static class DecisionSigning
{
    /// <summary>True if a user may decide so about a correction in this state.</summary>
    /// <param name="shell">The shell, and its current user.</param>
    /// <param name="act">To approve or to reject.</param>
    /// <param name="correction">The correction as shown.</param>
    public static bool IsPossible(ShellViewModel shell, Act act, Correction correction) =>
        shell.Who is { } who && Rights.Allows(who.Role, act) && (act == Act.Approve
            ? correction is { IsUndecided: true, ProgramSha256: not null }
            : CorrectionSteps.Allows(correction.State, CorrectionState.Rejected));

    /// <summary>Creates the signing dialog.</summary>
    /// <param name="shell">The shell that shows it, and its current user.</param>
    /// <param name="act">To approve or to reject.</param>
    /// <param name="kept">The correction as shown.</param>
    /// <param name="facts">Returns what an approver signs for.</param>
    public static SigningViewModel Of(ShellViewModel shell, Act act, StoredCorrection kept, Func<IReadOnlyList<Fact>> facts)
    {
        var (station, id) = (shell.Station, kept.Correction.Id);
        return new(
            station,
            shell.Who!,
            act,
            kept.Subject,
            needsReason: act == Act.Reject,
            (by, reason, _) =>
            {
                var decisions = new CorrectionDecisions(station.Store);
                if (act == Act.Approve)
                {
                    decisions.Approve(id, by.Name, reason);
                }
                else
                {
                    decisions.Reject(id, by.Name, reason!);
                }

                return Task.CompletedTask;
            })
        {
            Correction = kept.Correction,
            ConsequenceKey = act == Act.Approve
                ? () => Wait() is null ? "Act.Approve.Consequence" : "Act.Approve.Consequence.InLine"
                : null,
            Known = act == Act.Approve
                ? () => [.. Wait() is { } wait ? [new Fact(wait.Text, wait.Severity)] : Array.Empty<Fact>(), .. facts()]
                : null,
        };

        // Only one that somebody has to decide first.
        WaitReason? Wait() => station.State.Status is { } status && WaitReason.Of(status, id) is { Severity: Severity.Attention } wait
            ? wait
            : null;
    }
}
