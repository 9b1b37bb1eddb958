using System.Globalization;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>Progress of a long operation: one terminal line, rewritten for each percent and removed at the end.</summary>
/// <param name="terminal">The terminal; null if no person is watching.</param>
internal sealed class ProgressLine(TextWriter? terminal) : IProgress<CellProgress>, IDisposable
{
    private const int Width = 20;

    private string _shown = "";

    public void Report(CellProgress value)
    {
        var line = value.Of > 0
            ? string.Create(CultureInfo.InvariantCulture, $"{value.Doing}: {Bar(value)} {100 * value.Done / value.Of} %")
            : value.Doing + " ...";
        if (terminal is not null && line != _shown)
        {
            terminal.Write('\r' + line.PadRight(_shown.Length));
            _shown = line;
        }
    }

    private static string Bar(CellProgress value)
    {
        var done = (int)Math.Clamp(Width * value.Done / value.Of, 0, Width);
        return $"[{new string('#', done)}{new string('.', Width - done)}]";
    }

    public void Dispose()
    {
        if (_shown.Length > 0)
        {
            terminal!.Write('\r' + new string(' ', _shown.Length) + '\r');
        }
    }
}
