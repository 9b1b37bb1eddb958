using System.Globalization;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>How far long work is: one line of a terminal, written anew with each percent, and gone when the work is done.</summary>
/// <param name="terminal">The terminal; null if nobody sits there.</param>
internal sealed class ProgressLine(TextWriter? terminal) : IProgress<CellProgress>, IDisposable
{
    private string _shown = "";

    /// <inheritdoc/>
    public void Report(CellProgress value)
    {
        var line = value.Of > 0 ? string.Create(CultureInfo.InvariantCulture, $"{value.Doing}: {100 * value.Done / value.Of} %") : value.Doing + " ...";
        if (terminal is not null && line != _shown)
        {
            terminal.Write('\r' + line.PadRight(_shown.Length));
            _shown = line;
        }
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        if (_shown.Length > 0)
        {
            terminal!.Write('\r' + new string(' ', _shown.Length) + '\r');
        }
    }
}
