namespace ErrorMatching.Cell;

/// <summary>Checks whether files in a gauge's folder can be seen and moved out, without changing anything there.</summary>
/// <param name="gauge">The gauge, with a folder.</param>
/// <param name="clock">Measures how long a share has hung.</param>
internal sealed class GaugeAnswer(GaugeSettings gauge, TimeProvider clock)
{
    private static readonly TimeSpan Limit = TimeSpan.FromSeconds(20);
    private Task<AnswerProblem?>? _asking;

    /// <summary>Checks the folder.</summary>
    /// <returns>Null if it responds.</returns>
    public async Task<AnswerProblem?> OfAsync(CancellationToken cancellation)
    {
        // A share that hangs blocks one thread in total, not another one each time.
        if (_asking is not { IsCompleted: false })
        {
            _asking = Task.Run(Look, CancellationToken.None);
        }

        try
        {
            return await _asking.WaitAsync(Limit, clock, cancellation);
        }
        catch (TimeoutException)
        {
            return new(CellCodes.GaugeAway, Sentence(FormattableString.Invariant($"nothing came within {Limit.TotalSeconds:0} s")));
        }
    }

    private AnswerProblem? Look()
    {
        var folder = gauge.Incoming!;
        try
        {
            using (var items = Directory.EnumerateFileSystemEntries(folder).GetEnumerator())
            {
                items.MoveNext();
            }

            using var aside = PinnedFolder.Open(Path.Combine(folder, ClaimFolder.Name));
            var places = aside is null ? new[] { folder } : [folder, aside.Path];
            return OperatingSystem.IsLinux() && places.Select(LinuxCalls.WhyNotWritable).FirstOrDefault(w => w is not null) is { } why
                ? new(
                    CellCodes.GaugeDenied,
                    $"Files cannot be taken out of the folder {folder} of the gauge \"{gauge.Name}\": {why.Message.TrimEnd('.')}. "
                    + "Give it to the user that the cell runs as.")
                : null;
        }
        catch (NotPlainFolderException e)
        {
            return new(CellCodes.GaugeDenied,
                $"Nothing is taken out of the folder of the gauge \"{gauge.Name}\": {e.Message.TrimEnd('.')}.");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return new(CellCodes.GaugeAway, Sentence(e.Message.TrimEnd('.')));
        }
    }

    private string Sentence(string why) =>
        $"The folder {gauge.Incoming} of the gauge \"{gauge.Name}\" cannot be looked into: {why}. "
        + "Is it there, is the share mounted, and may this user read it?";
}
