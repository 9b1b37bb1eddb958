using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Which correction is selected: the one that the user chose, otherwise the longest-waiting one.</summary>
/// <param name="shell">Remembers the choice for the next time that the screen is opened.</param>
internal sealed class LookedCorrection(ShellViewModel shell)
{
    private long? _looked = shell.Looked.Correction;
    private long? _byItself = shell.Looked.Shown;
    private HashSet<long> _waiting = [];
    private bool _isOpened;

    /// <summary>Number of the selected correction; null if there is none.</summary>
    public long? Current => _looked ?? _byItself;

    /// <summary>Takes the user's choice.</summary>
    public void Look(long id) => shell.Looked.Correction = _looked = id;

    /// <summary>Keeps the user's choice even if it is not listed yet.</summary>
    public void Open() => _isOpened = true;

    /// <summary>Finds the selected correction of a new list.</summary>
    /// <param name="rows">The list.</param>
    /// <param name="waiting">The corrections that wait for this user.</param>
    /// <param name="inWork">Those that are being calculated.</param>
    /// <returns>Its number; null if there is none.</returns>
    public long? Follow(IReadOnlyList<ListedCorrection> rows, IEnumerable<Correction> waiting, IEnumerable<Correction> inWork)
    {
        _waiting = [.. waiting.Select(c => c.Id)];

        // A returning user finds the last selection, unless that correction is gone. One being recalculated will still appear.
        _looked = _isOpened || rows.Any(r => r.Id == _looked) || inWork.Any(c => c.Id == _looked) ? _looked : null;
        _isOpened = true;
        return _looked ?? ByItself(rows);
    }

    /// <summary>The next one that waits for this user after a decision: the first one below the decided one, or else from the
    /// top.</summary>
    /// <param name="rows">The list.</param>
    /// <param name="decided">Number of the decided one.</param>
    /// <returns>Its number; null if no other one waits.</returns>
    public long? Next(IReadOnlyList<ListedCorrection> rows, long decided)
    {
        var at = rows.TakeWhile(r => r.Id != decided).Count();
        return rows.Skip(at + 1).Concat(rows.Take(at)).FirstOrDefault(r => _waiting.Contains(r.Id))?.Id;
    }

    /// <summary>Remembers which one was selected automatically.</summary>
    public void Remember() => shell.Looked.Shown = _byItself;

    // A waiting correction stays selected until it is decided; then the next one is. If none is left, the last one stays visible.
    private long? ByItself(IReadOnlyList<ListedCorrection> rows)
    {
        var now = rows.FirstOrDefault(r => r.Id == _byItself);
        var row = now is not null && _waiting.Contains(now.Id)
            ? now
            : rows.FirstOrDefault(r => _waiting.Contains(r.Id)) ?? now ?? (_byItself is null && rows is [var first, ..] ? first : null);
        return _byItself = row?.Id ?? _byItself;
    }
}
