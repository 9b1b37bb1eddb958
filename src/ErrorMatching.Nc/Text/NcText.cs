using System.Text;

namespace ErrorMatching.Nc;

/// <summary>Decodes a program's bytes to text for people and patterns.</summary>
internal static class NcText
{
    private static readonly UTF8Encoding Strict = new(encoderShouldEmitUTF8Identifier: false, throwOnInvalidBytes: true);

    /// <summary>UTF-8 if the bytes are valid UTF-8, otherwise Latin-1, in which every byte is a character.</summary>
    public static string Decode(ReadOnlySpan<byte> bytes)
    {
        if (System.Text.Unicode.Utf8.IsValid(bytes))
        {
            return Strict.GetString(bytes);
        }

        return Encoding.Latin1.GetString(bytes);
    }
}
