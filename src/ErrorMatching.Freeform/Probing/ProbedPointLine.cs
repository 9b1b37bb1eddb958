using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads one line of a probing log that says a point (<see cref="ProbedLine"/>).</summary>
/// <param name="file">The log.</param>
/// <param name="line">The line, without spaces around it.</param>
/// <param name="number">Its number in the file, from 1.</param>
internal sealed class ProbedPointLine(string file, string line, int number)
{
    /// <summary>The point.</summary>
    /// <exception cref="InputException">The line says none.</exception>
    public RawPoint Read() => ProbedLine.Read(line, out var read) is { } touch
        ? new(touch.Number, null, null, touch.Position, touch.IsCenter, number)
        : throw InputException.At(
            "bad-log",
            file,
            FormattableString.Invariant(
                $"found {ProbingLogReader.Shown(line)} at character {read + 1}; expected a point such as {ProbedLine.Example}."),
            number,
            read + 1);
}
