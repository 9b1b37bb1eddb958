using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The 80-column records of a fixed-form IGES file, sorted by section (IGES 5.3, section 2.2).</summary>
/// <remarks>A missing start or terminate section does not affect the geometry and is accepted.</remarks>
internal sealed class IgesSections
{
    private const int SectionColumn = 72;
    private const int RecordLength = 80;

    private readonly string _text;
    private readonly List<(int Offset, int Line)> _global = [];
    private readonly List<(int Offset, int Line)> _directory = [];
    private readonly List<(int Offset, int Line)> _parameters = [];

    /// <summary>Sorts the records of a file.</summary>
    /// <exception cref="InputException">A line is not an IGES record, or records are missing.</exception>
    public IgesSections(ReadOnlySpan<byte> bytes, string file)
    {
        File = file;
        _text = Encoding.Latin1.GetString(bytes);
        var (start, line) = (0, 0);
        while (start < _text.Length)
        {
            line++;
            var end = _text.IndexOf('\n', start);
            end = end < 0 ? _text.Length : end;
            if (end - start > RecordLength + 1 && (end - start) % RecordLength == 0)
            {
                end = start + RecordLength;
            }

            if (!Add(start, end, line))
            {
                break;
            }

            start = end < _text.Length && _text[end] == '\n' ? end + 1 : end;
        }
    }

    public string File { get; }

    public int DirectoryCount => _directory.Count;

    public int ParameterCount => _parameters.Count;

    /// <summary>The 72 columns of a global record; null after the last.</summary>
    public ReadOnlyMemory<char>? Global(int record) =>
        record < _global.Count ? _text.AsMemory(_global[record].Offset, SectionColumn) : default(ReadOnlyMemory<char>?);

    /// <summary>Line of a global record; 1 if there is none.</summary>
    public int GlobalLine(int record) => _global.Count == 0 ? 1 : _global[Math.Min(record, _global.Count - 1)].Line;

    /// <summary>An 8-column field of a directory record.</summary>
    /// <param name="record">Number of the record from 0.</param>
    /// <param name="field">Number of the field from 0 to 8.</param>
    public string Field(int record, int field) => _text.Substring(_directory[record].Offset + (8 * field), 8);

    public int DirectoryLine(int record) => _directory[record].Line;

    /// <summary>The 64 data columns of a parameter record; null after the last.</summary>
    public ReadOnlyMemory<char>? Parameters(int record) =>
        record < _parameters.Count ? _text.AsMemory(_parameters[record].Offset, 64) : default(ReadOnlyMemory<char>?);

    public int ParameterLine(int record) => _parameters[Math.Clamp(record, 0, _parameters.Count - 1)].Line;

    private bool Add(int start, int end, int line)
    {
        while (end > start && _text[end - 1] is '\r' or '\n')
        {
            end--;
        }

        var length = end - start;
        while (length > RecordLength && char.IsWhiteSpace(_text[start + length - 1]))
        {
            length--;
        }

        if (length == 0 || _text.AsSpan(start, length).IsWhiteSpace())
        {
            return true;
        }

        if (length is <= SectionColumn or > RecordLength)
        {
            throw Fail(
                "bad-record", $"a record of {length} columns; IGES records have 80, with the letter of their section in column 73", line);
        }

        switch (_text[start + SectionColumn])
        {
            case 'S':
                return true;
            case 'G':
                Numbered(_global, start, length, line);
                return true;
            case 'D':
                Numbered(_directory, start, length, line);
                return true;
            case 'P':
                Numbered(_parameters, start, length, line);
                return true;
            case 'T':
                return false;
            case 'C':
                throw Fail("compressed", "the compressed form of IGES, which is not read: export the fixed form (80 columns)", line);
            case 'B':
                throw Fail("binary", "the binary form of IGES, which is not read: export the fixed form (80 columns)", line);
            default:
                throw Fail(
                    "bad-record",
                    $"{ExchangeLimits.Quote(_text.Substring(start + SectionColumn, 1))} in column 73; the letter of a section (S, G, D, "
                        + $"P, T) is expected",
                    line);
        }
    }

    private void Numbered(List<(int Offset, int Line)> section, int start, int length, int line)
    {
        var number = _text.AsSpan(start + SectionColumn + 1, length - SectionColumn - 1).Trim();
        if (!number.IsEmpty
            && (!int.TryParse(number, NumberStyles.None, CultureInfo.InvariantCulture, out var n) || n != section.Count + 1))
        {
            throw Fail(
                "bad-record",
                $"record number {ExchangeLimits.Quote(number.ToString())} in columns 74 to 80; {section.Count + 1} is expected: records "
                    + $"are missing or out of order",
                line);
        }

        section.Add((start, line));
    }

    private InputException Fail(string code, string problem, int line) => InputException.At(code, File, problem, line);
}
