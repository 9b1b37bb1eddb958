using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>Progress of a long operation on a store, as a line of the terminal. It is apart from <see cref="ProgressLine"/>, so that verbs
/// without a cell load nothing of cells.</summary>
/// <param name="terminal">The terminal; null if no person is watching.</param>
internal sealed class CellProgressLine(TextWriter? terminal) : IProgress<CellProgress>, IDisposable
{
    private readonly ProgressLine _line = new(terminal);

    public void Report(CellProgress value) => _line.Show(value.Doing, value.Done, value.Of);

    public void Dispose() => _line.Dispose();
}
