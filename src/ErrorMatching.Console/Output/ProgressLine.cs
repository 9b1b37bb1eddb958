using System.Globalization;

namespace ErrorMatching.Console;

/// <summary>Progress of a long operation: one terminal line, rewritten for each percent and removed at the end.</summary>
/// <param name="terminal">The terminal; null if no person is watching.</param>
internal sealed class ProgressLine(TextWriter? terminal) : IDisposable
{
    private const int Width = 20;

    private string _shown = "";

    /// <summary>Shows how far an operation is.</summary>
    /// <param name="doing">What is being done, in a few words.</param>
    /// <param name="done">The amount done.</param>
    /// <param name="of">The total; 0 if unknown.</param>
    public void Show(string doing, long done, long of)
    {
        var line = of > 0 ? string.Create(CultureInfo.InvariantCulture, $"{doing}: {Bar(done, of)} {100 * done / of} %") : doing + " ...";
        if (terminal is not null && line != _shown)
        {
            terminal.Write('\r' + line.PadRight(_shown.Length));
            _shown = line;
        }
    }

    private static string Bar(long done, long of)
    {
        var filled = (int)Math.Clamp(Width * done / of, 0, Width);
        return $"[{new string('#', filled)}{new string('.', Width - filled)}]";
    }

    public void Dispose()
    {
        if (_shown.Length > 0)
        {
            terminal!.Write('\r' + new string(' ', _shown.Length) + '\r');
        }
    }
}
