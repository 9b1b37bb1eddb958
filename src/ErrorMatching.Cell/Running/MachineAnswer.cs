namespace ErrorMatching.Cell;

/// <summary>Asks a machine whether it answers, without changing anything there.</summary>
internal static class MachineAnswer
{
    /// <summary>Asks.</summary>
    /// <returns>Null if it answers.</returns>
    public static async Task<AnswerProblem?> OfAsync(MachineSettings machine, IMachineFolder folder, CancellationToken cancellation)
    {
        try
        {
            await folder.ListAsync(cancellation);

            // Programs are written there. A server tells only when one is.
            return machine is { Transport.LocalFolder: { } path, Slots.Count: > 0 } && OperatingSystem.IsLinux()
                && LinuxCalls.WhyNotWritable(path) is { } why
                ? Problem(TransportFailure.Of(TransportError.Denied, machine.Name, $"looking whether programs may be written into {path}",
                    why.Message))
                : null;
        }
        catch (TransportException e)
        {
            return Problem(e);
        }
    }

    private static AnswerProblem Problem(TransportException e) =>
        new(CellCodes.Of(e.Error), e.Message, e.Error is TransportError.Login or TransportError.WrongServer);
}
