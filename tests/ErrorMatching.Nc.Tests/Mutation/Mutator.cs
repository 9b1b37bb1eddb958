using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>Damages the programs of the corpus: the same seed gives the same bytes on every machine.</summary>
internal sealed class Mutator
{
    private static readonly string[] Extremes =
    [
        "0", "-0", "+0.", ".", "-", "1e9", "999999999999999999", "-999999999999999999", "9223372036854775807", "9223372036854775808",
        "0.000000000000000000001", "1000000000", "-1000000000.0001",
        "123456789.123456789", "00000000000000000001", "2147483647", "2147483648", "-.5", "5.", "+3.", "1.7976931348623157e308", "#1",
        "[1/0]", "=R1+5", "[[[[[1]]]]]", "1 2", "NaN", "",
    ];

    private static readonly string[] Pieces =
    [
        "(", ")", "[", "]", "#", "=", ";", "%", "/", "\"", "\n", "\r", "\r\n", "\0", "\x1a", "\t", " ", "G1", "G2", "G3", "G91", "G90.1",
        "G20", "G18", "G41", "G68 X0 Y0 R30.", "G51 P2000", "G92 X0", "G10 L2 P1 X1", "M98 P1", "M99", "M30",
        "O1 call", "o1 while [1]", "GOTO10", "WHILE[1]DO1", "END1", "LOOP", "ENDLOOP", "REPEAT", "GOTOB A", "A:", "MSG(\"", "CYCLE81(,,,",
        "TRANS X5", "ROT", "X=IC(1)", "CR=5", "TURN=2", "P3", "L999999999", ",R1.", "N10", "$A", "@",
        "IF [VC1 LT 5] NA", "CALL O1 Q2 PA=1", "MODIN O1", "RTS", "X=VC1+", "VC1=VC1*2",
    ];

    private static readonly Lazy<(string Name, byte[] Bytes)[]> Programs = new(ReadCorpus);
    private ulong _state;

    public Mutator(long seed) => _state = (ulong)seed * 0x9E3779B97F4A7C15UL;

    /// <summary>The corpus: short programs of each family of controls, and the samples.</summary>
    public static IReadOnlyList<(string Name, byte[] Bytes)> Corpus => Programs.Value;

    /// <summary>A damaged program.</summary>
    public byte[] Next()
    {
        var bytes = Any().ToList();
        for (var n = 1 + Below(6); n > 0; n--)
        {
            Mutate(bytes);
        }

        return [.. bytes];
    }

    /// <summary>A number from 0 to below a count.</summary>
    public int Below(int count)
    {
        _state += 0x9E3779B97F4A7C15UL;
        var mixed = (_state ^ (_state >> 30)) * 0xBF58476D1CE4E5B9UL;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBUL;
        return (int)((mixed ^ (mixed >> 31)) % (ulong)Math.Max(1, count));
    }

    private void Mutate(List<byte> bytes)
    {
        var at = Below(bytes.Count + 1);
        switch (Below(10))
        {
            case 0 when at < bytes.Count: // Flips a bit.
                bytes[at] ^= (byte)(1 << Below(8));
                break;
            case 1: // Inserts any byte.
                bytes.Insert(at, (byte)Below(256));
                break;
            case 2: // Deletes a stretch.
                bytes.RemoveRange(at, Math.Min(bytes.Count - at, Below(12)));
                break;
            case 3: // Repeats a line, once or often.
                var line = Line(bytes, at);
                for (var n = Below(10) == 0 ? 100 : 1; n > 0; n--)
                {
                    bytes.InsertRange(line.Start, bytes.GetRange(line.Start, line.Length));
                }

                break;
            case 4: // Joins the front of one program and the back of another.
                var other = Any();
                bytes.RemoveRange(at, bytes.Count - at);
                bytes.AddRange(other.AsSpan(Below(other.Length + 1)));
                break;
            case 5: // Puts an extreme number where one stands.
                var number = bytes.FindIndex(at, b => b is >= (byte)'0' and <= (byte)'9');
                if (number >= 0)
                {
                    var end = bytes.FindIndex(number, b => b is not ((>= (byte)'0' and <= (byte)'9') or (byte)'.'));
                    bytes.RemoveRange(number, (end < 0 ? bytes.Count : end) - number);
                    bytes.InsertRange(number, Encoding.Latin1.GetBytes(Extremes[Below(Extremes.Length)]));
                }

                break;
            case 6: // Nests deep.
                var depth = Below(20) == 0 ? 5000 : 1 + Below(40);
                bytes.InsertRange(
                    at, Encoding.Latin1.GetBytes($"{"XYZR#FP"[Below(7)]}{new string('[', depth)}1{new string(']', Below(depth + 1))}"));
                break;
            case 7: // Swaps two lines.
                var (a, b) = (Line(bytes, at), Line(bytes, Below(bytes.Count + 1)));
                var moved = bytes.GetRange(a.Start, a.Length);
                bytes.InsertRange(b.Start, moved);
                break;
            default: // Inserts a piece of some control's language.
                bytes.InsertRange(at, Encoding.Latin1.GetBytes(Pieces[Below(Pieces.Length)]));
                break;
        }
    }

    private static (int Start, int Length) Line(List<byte> bytes, int at)
    {
        var start = at == 0 ? 0 : bytes.LastIndexOf((byte)'\n', at - 1) + 1;
        var end = bytes.IndexOf((byte)'\n', start);
        return (start, (end < 0 ? bytes.Count : end + 1) - start);
    }

    private byte[] Any() => Corpus[Below(Corpus.Count)].Bytes;

    private static (string Name, byte[] Bytes)[] ReadCorpus() =>
    [
        .. new[] { Repository.PathTo("tests", "ErrorMatching.Nc.Tests", "Corpus"), Repository.PathTo("samples") }
            .SelectMany(f => Directory.EnumerateFiles(f, "*.nc", SearchOption.AllDirectories))
            .Order(StringComparer.Ordinal)
            .Select(f => (Path.GetRelativePath(Repository.Root, f), File.ReadAllBytes(f))),
    ];
}
