using System.Text;

namespace ErrorMatching.Hmi;

/// <summary>
/// A code from a barcode scanner, which is a keyboard to us: characters while no field has the focus, ended by Enter. Nothing else takes such characters, so they need not be told from typing
/// by their speed; a pause only ends what somebody's sleeve began.
/// </summary>
/// <param name="clock">For the pause.</param>
public sealed class ScannedCode(TimeProvider clock)
{
    /// <summary>Longer ones are no serial numbers.</summary>
    public const int Most = 128;

    /// <summary>A scanner never waits so long between two characters.</summary>
    public static readonly TimeSpan Pause = TimeSpan.FromSeconds(1);

    private readonly StringBuilder _code = new();
    private long _last;

    /// <summary>Takes characters.</summary>
    public void Add(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        ForgetIfOld();
        foreach (var c in text.Where(c => !char.IsControl(c)))
        {
            // One too long is none, also when it ends: it is kept one too long.
            _code.Append(c, _code.Length <= Most ? 1 : 0);
        }

        _last = clock.GetTimestamp();
    }

    /// <summary>Takes Enter.</summary>
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
