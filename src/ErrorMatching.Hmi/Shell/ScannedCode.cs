using System.Text;

namespace ErrorMatching.Hmi;

/// <summary>Input from a barcode scanner, which acts as a keyboard: characters while no field has the focus, ended by Enter.
/// Nothing else uses such characters, so their speed does not matter. A pause only discards accidental key presses.</summary>
/// <param name="clock">Times the pauses.</param>
internal sealed class ScannedCode(TimeProvider clock)
{
    /// <summary>Maximum length: longer codes are not serial numbers.</summary>
    public const int Most = 128;

    /// <summary>A scanner never pauses this long between two characters.</summary>
    public static readonly TimeSpan Pause = TimeSpan.FromSeconds(1);

    private readonly StringBuilder _code = new();
    private long _last;

    /// <summary>Adds characters.</summary>
    public void Add(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        ForgetIfOld();
        foreach (var c in text.Where(c => !char.IsControl(c)))
        {
            // A code that is too long is invalid at its end, too: it keeps one character too many.
            _code.Append(c, _code.Length <= Most ? 1 : 0);
        }

        _last = clock.GetTimestamp();
    }

    /// <summary>Handles Enter.</summary>
    /// <returns>The code; null if there is none.</returns>
    public string? End()
    {
        ForgetIfOld();
        var code = _code.Length <= Most ? _code.ToString().Trim() : "";
        _code.Clear();
        return code.Length > 0 ? code : null;
    }

    private void ForgetIfOld()
    {
        if (clock.GetElapsedTime(_last) > Pause)
        {
            _code.Clear();
        }
    }
}
