using System.Buffers;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Whether bytes can be a program: text in which each character of a word is one byte.</summary>
public static class ProgramContent
{
    // Enough to tell an encoding or a picture from a program.
    private const int Looked = 1 << 16;

    // Stray control characters are told by the tokenizer; this many are no program.
    private const int OneIn = 10;
    private const int Few = 4;

    // Tapes have their start and stop codes, and NUL, before and behind the program.
    private static readonly SearchValues<byte> Blank = SearchValues.Create("\0 \t\r\n\f\v\u001a"u8);

    /// <summary>Why the bytes are no program; null if they can be one.</summary>
    public static Refusal? Problem(ReadOnlySpan<byte> bytes)
    {
        if (MarkOf(bytes) is { } encoding)
        {
            return NotText($"text in {encoding}");
        }

        var text = bytes.StartsWith("\uFEFF"u8) ? bytes["\uFEFF"u8.Length..] : bytes;
        var start = text.IndexOfAnyExcept(Blank);
        if (start < 0)
        {
            return Refusal.Of(
                NcInputCodes.EmptyProgram,
                bytes.IsEmpty ? "an empty file" : "a file without a block",
                "an NC program: save it, or transfer it, as a whole");
        }

        text = text[start..(text.LastIndexOfAnyExcept(Blank) + 1)];
        text = text[..Math.Min(text.Length, Looked)];
        var nuls = text.Count((byte)0);

        // The characters of a program are one byte each, so that two or four bytes for each leave one or three of them NUL.
        return nuls >= text.Length / 4 && nuls > 0 ? NotText("text in UTF-16 or UTF-32")
            : text.StartsWith("%PDF-"u8) ? NotText("a PDF document")
            : Controls(text) > Math.Max(Few, text.Length / OneIn) ? NotText("a binary file")
            : null;
    }

    private static string? MarkOf(ReadOnlySpan<byte> bytes) =>
        bytes.StartsWith<byte>([0xFF, 0xFE, 0, 0]) || bytes.StartsWith<byte>([0, 0, 0xFE, 0xFF]) ? "UTF-32"
            : bytes.StartsWith<byte>([0xFF, 0xFE]) || bytes.StartsWith<byte>([0xFE, 0xFF]) ? "UTF-16"
            : null;

    private static int Controls(ReadOnlySpan<byte> text)
    {
        var count = 0;
        foreach (var b in text)
        {
            count += b is < 0x20 or 0x7F && !Blank.Contains(b) ? 1 : 0;
        }

        return count + text.Count((byte)0);
    }

    private static Refusal NotText(string found) => Refusal.Of(
        NcInputCodes.ProgramNotText, found, "an NC program as plain text: save it as ASCII (ANSI) or UTF-8");
}
