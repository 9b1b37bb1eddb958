using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>Every byte outside the values of words that had to change must be the original's.</content>
public sealed partial class Prover
{
    /// <summary>Stands for a value that changed; no program has this byte in a word.</summary>
    private const byte ChangedValue = 0xFF;

    private bool CompareBytes(int markerBlock)
    {
        var identical = true;
        var (was, now) = (_before.Program, _after.Program);
        for (var i = 0; i < was.BlockCount; i++)
        {
            var (a, b) = (was[i], now[InResult(i, markerBlock)]);
            if (was.Bytes.Span.Slice(a.Start, a.FullLength).SequenceEqual(now.Bytes.Span.Slice(b.Start, b.FullLength)))
            {
                continue;
            }

            var motion = _before.MotionOf(i);
            if (motion < 0 || !SameButCoordinates(motion, a, b))
            {
                Fail(i, "something other than the words of its new place changed in it.");
                identical = false;
            }
            else if (Obstacles.Of(_before, motion) is { } obstacle)
            {
                Fail(i, $"it changed although {obstacle.Message}");
            }
        }

        return identical;
    }

    private bool SameButCoordinates(int motion, NcBlock a, NcBlock b)
    {
        var (was, now) = (_before.Motions[motion], _after.Motions[motion]);
        var (original, result) = (WordsOf(_before.Program, a), WordsOf(_after.Program, b));
        return Remainder(_before.Program, a, Judge(was, now, original, result, inOriginal: true))
            .SequenceEqual(Remainder(_after.Program, b, Judge(was, now, result, original, inOriginal: false)));
    }

    private static Dictionary<byte, NcNumber> WordsOf(NcProgram program, NcBlock block)
    {
        var words = new Dictionary<byte, NcNumber>();
        foreach (var token in program.Tokens(block))
        {
            if (token.Kind == NcTokenKind.Word)
            {
                words[token.Letter] = token.Number;
            }
        }

        return words;
    }

    // For each letter: true if its value may differ, false if the whole word may be there in one of the two programs only.
    private static Dictionary<byte, bool> Judge(in NcMotion was, in NcMotion now, Dictionary<byte, NcNumber> own, Dictionary<byte, NcNumber> other, bool inOriginal)
    {
        var isRadiusReplaced = was.Has(MotionFlags.ByRadius) && !now.Has(MotionFlags.ByRadius);
        var judged = new Dictionary<byte, bool>();
        foreach (var letter in was.IsArc ? was.Plane switch { CoordinatePlane.ZX => "XYZKIR"u8, CoordinatePlane.YZ => "XYZJKR"u8, _ => "XYZIJR"u8 } : "XYZ"u8)
        {
            if (!own.TryGetValue(letter, out var value))
            {
                continue;
            }

            if (other.TryGetValue(letter, out var otherValue))
            {
                if (!value.SameValue(otherValue))
                {
                    judged.Add(letter, true);
                }
            }
            else if (inOriginal ? letter == 'R' && isRadiusReplaced : IsNeeded(letter, value, now, isRadiusReplaced))
            {
                judged.Add(letter, false);
            }
        }

        return judged;
    }

    // A word is inserted only where the axis moves now although it did not before, or for a center.
    private static bool IsNeeded(byte letter, NcNumber value, in NcMotion now, bool isRadiusReplaced) => letter switch
    {
        (byte)'X' => Math.Abs(now.End.X - now.Start.X) > 1e-9,
        (byte)'Y' => Math.Abs(now.End.Y - now.Start.Y) > 1e-9,
        (byte)'Z' => Math.Abs(now.End.Z - now.Start.Z) > 1e-9,
        (byte)'R' => false,
        _ => isRadiusReplaced || value.Digits != 0,
    };

    // The block with changed values masked, and words that only one program has left out together with the one space that separates them.
    private static List<byte> Remainder(NcProgram program, NcBlock block, Dictionary<byte, bool> judged)
    {
        var bytes = program.Bytes.Span;
        var (rest, skipSpace) = (new List<byte>(block.FullLength), false);
        foreach (var token in program.Tokens(block))
        {
            if (token.Kind == NcTokenKind.Word && judged.TryGetValue(token.Letter, out var isValueChange))
            {
                if (isValueChange)
                {
                    rest.AddRange(bytes[token.Start..token.ValueStart]);
                    rest.Add(ChangedValue);
                }
                else if (rest.Count > 0 && rest[^1] == ' ')
                {
                    rest.RemoveAt(rest.Count - 1);
                }
                else
                {
                    skipSpace = rest.Count == 0;
                    continue;
                }
            }
            else if (!(skipSpace && token is { Kind: NcTokenKind.Space, Length: 1 }))
            {
                rest.AddRange(bytes.Slice(token.Start, token.Length));
            }

            skipSpace = false;
        }

        rest.AddRange(bytes[block.End..(block.Start + block.FullLength)]);
        return rest;
    }
}
