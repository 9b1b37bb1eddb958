namespace ErrorMatching.Cell;

/// <summary>Checks whether a machine responds, without changing anything there.</summary>
internal static class MachineAnswer
{
    /// <summary>Checks the machine.</summary>
    /// <returns>Null if it responds.</returns>
    public static async Task<AnswerProblem?> OfAsync(MachineSettings machine, IMachineFolder folder, CancellationToken cancellation)
    {
        try
        {
            await folder.ListAsync(cancellation);

            // Programs are written there. A server tells whether that is possible only when one is written.
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
