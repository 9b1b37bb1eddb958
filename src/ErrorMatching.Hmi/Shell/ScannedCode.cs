using System.Text;

namespace ErrorMatching.Hmi;

/// <summary>Tells the code of a barcode scanner, which acts as a keyboard, from typing by hand: a scanner announces its code by a prefix,
/// or it is faster than any hand. It ends each code with Enter. All times are those of the key presses, in milliseconds: after a delay, a
/// station handles typed keys as quickly as scanned ones.</summary>
internal sealed class ScannedCode
{
    /// <summary>Maximum length: longer codes are not serial numbers.</summary>
    public const int Most = 128;

    /// <summary>Minimum length without a prefix: two keys may be pressed at the same time by accident.</summary>
    public const int Least = 3;

    /// <summary>Maximum time between two keys of a scanner without a prefix. Fast typists need more than 60 ms on average.</summary>
    public const ulong Fast = 50;

    /// <summary>Maximum time between two keys of a scanner with a prefix. After a longer time, a new code begins.</summary>
    public const ulong Pause = 1000;

    private readonly StringBuilder _code = new();
    private ulong _last;
    private int _fastFrom;
    private bool _isByHand;

    /// <summary>True from the prefix to the end of its code.</summary>
    public bool IsAnnounced { get; private set; }

    /// <summary>Handles the prefix.</summary>
    /// <param name="at">When it was sent.</param>
    public void Announce(ulong at)
    {
        Clear();
        (IsAnnounced, _last) = (true, at);
    }

    /// <summary>Adds characters.</summary>
    /// <param name="text">The characters.</param>
    /// <param name="at">When they were typed.</param>
    public void Add(string text, ulong at)
    {
        ArgumentNullException.ThrowIfNull(text);
        Judge(at);
        foreach (var c in text.Where(c => !char.IsControl(c)))
        {
            // A code that is too long is invalid at its end, too: it keeps one character too many.
            _code.Append(c, _code.Length <= Most ? 1 : 0);
        }

        _last = at;
    }

    /// <summary>Handles Enter.</summary>
    /// <param name="at">When it was pressed.</param>
    /// <param name="leastBadge">The fewest characters of a badge if one is expected: then what was as fast as a scanner is the code, also
    /// right after typing by hand. Null for the code of a piece.</param>
    /// <returns>The code; null if there is none, or if it was typed by hand.</returns>
    public string? End(ulong at, int? leastBadge = null)
    {
        Judge(at);
        if (leastBadge is { } fewest && !IsAnnounced)
        {
            var badge = _code.ToString(_fastFrom, _code.Length - _fastFrom).Trim();
            var isBadge = badge.Length >= fewest && _code.Length <= Most;
            Clear();
            return isBadge ? badge : null;
        }

        var (code, least) = (_code.ToString().Trim(), IsAnnounced ? 1 : Least);
        var isCode = !_isByHand && _code.Length <= Most && code.Length >= least;
        Clear();
        return isCode ? code : null;
    }

    /// <summary>Forgets what was typed.</summary>
    public void Clear()
    {
        _code.Clear();
        (IsAnnounced, _isByHand, _fastFrom) = (false, false, 0);
    }

    // One slow key makes all of it typed by hand: its last characters may have been fast by chance.
    private void Judge(ulong at)
    {
        var since = at - _last;
        if (since > Pause)
        {
            Clear();
        }
        else
        {
            _isByHand |= !IsAnnounced && _code.Length > 0 && since > Fast;
            _fastFrom = since > Fast ? _code.Length : _fastFrom;
        }
    }
}
