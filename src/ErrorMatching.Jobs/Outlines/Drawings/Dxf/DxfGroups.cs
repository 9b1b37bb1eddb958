using System.Buffers.Binary;
using System.Buffers.Text;
using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Walks through the groups of a DXF file, pairs of a code and a value, in text or binary form.</summary>
internal sealed class DxfGroups
{
    private const int Comment = 999;
    private readonly byte[] _bytes;
    private readonly bool _hasShortCodes;
    private int _at;
    private int _line = 1;
    private int _start;
    private int _length;
    private double _number;
    private bool _isNumber;

    /// <summary>Recognizes the form of a file and starts before its first group.</summary>
    /// <exception cref="InputException">The file is a drawing in another format.</exception>
    public DxfGroups(byte[] bytes, string file)
    {
        (_bytes, File) = (bytes, file);
        if (bytes.AsSpan().StartsWith("AutoCAD Binary DXF\r\n\x1a\0"u8))
        {
            IsBinary = true;
            _at = 22;

            // R12 and R13 write codes of one byte, later versions two. The first group is 0 or 999.
            _hasShortCodes = bytes.Length > 23 && (bytes[22] == byte.MaxValue || bytes[23] > 4);
            return;
        }

        if (bytes is [(byte)'A', (byte)'C', (byte)'1' or (byte)'2', >= (byte)'0' and <= (byte)'9', ..])
        {
            var version = Encoding.Latin1.GetString(bytes, 0, Math.Min(6, bytes.Length));
            throw InputException.At(
                "not-dxf",
                file,
                $"this is a DWG file ({DrawingLimits.Quote(version)}); a DXF file is expected: save the drawing as DXF",
                1);
        }

        if (bytes is [0xFF, 0xFE, ..] or [0xFE, 0xFF, ..])
        {
            throw InputException.At("not-dxf", file, "text in UTF-16; a DXF file in ASCII, in a code page or in UTF-8 is expected", 1);
        }

        _at = bytes is [0xEF, 0xBB, 0xBF, ..] ? 3 : 0;
    }

    /// <summary>The file as the caller named it.</summary>
    public string File { get; }

    /// <summary>True if the file is in binary form, so that places are bytes and not lines.</summary>
    public bool IsBinary { get; }

    /// <summary>Code of the group.</summary>
    public int Code { get; private set; }

    /// <summary>Line of the group's code, from 1, or its offset in a binary file.</summary>
    public int Place { get; private set; }

    /// <summary>The bytes of the group's value without blanks around it; empty for numbers of binary files.</summary>
    public ReadOnlySpan<byte> Text => _bytes.AsSpan(_start, _length);

    /// <summary>Where the next group begins.</summary>
    public (int Offset, int Line) Position
    {
        get => (_at, _line);
        set => (_at, _line) = value;
    }

    /// <summary>Reads the next group that is no comment.</summary>
    /// <exception cref="InputException">The file ends, or something else than a group follows.</exception>
    public void Next()
    {
        do
        {
            (_start, _length, _isNumber) = (0, 0, false);
            if (IsBinary)
            {
                NextBinary();
            }
            else
            {
                NextText();
            }
        }
        while (Code == Comment);
    }

    /// <summary>The value as a finite number.</summary>
    /// <param name="entity">What it belongs to, for the message.</param>
    public double Number(string entity)
    {
        var value = _isNumber ? _number
            : double.TryParse(Text, NumberStyles.Float, CultureInfo.InvariantCulture, out var parsed) ? parsed
            : throw BadValue(entity, DrawingLimits.Quote(Latin()), "a number");
        return double.IsFinite(value) ? value : throw BadValue(entity, DrawingLimits.Quote(Shown(value)), "a finite number");
    }

    /// <summary>The value as a whole number.</summary>
    /// <param name="entity">What it belongs to, for the message.</param>
    public int Integer(string entity)
    {
        if (_isNumber)
        {
            return _number is >= int.MinValue and <= int.MaxValue && Math.Floor(_number) == _number
                ? (int)_number
                : throw BadValue(entity, DrawingLimits.Quote(Shown(_number)), "a whole number");
        }

        return Utf8Parser.TryParse(Text, out int value, out var used) && used == _length
            ? value
            : throw BadValue(entity, DrawingLimits.Quote(Latin()), "a whole number");
    }

    /// <summary>The value for a message, byte by byte.</summary>
    public string Latin() => Encoding.Latin1.GetString(Text[..Math.Min(_length, 2 * DrawingLimits.MaxQuoted)]);

    /// <summary>An error at the present group.</summary>
    public InputException Fail(string code, string problem) => FailAt(code, Place, problem);

    /// <summary>An error at the place of a group.</summary>
    public InputException FailAt(string code, int place, string problem) => IsBinary
        ? InputException.At(code, File, $"{Where(place)}: {problem}")
        : InputException.At(code, File, problem, place);

    /// <summary>A place in words.</summary>
    public string Where(int place) => string.Create(CultureInfo.InvariantCulture, $"{(IsBinary ? "byte" : "line")} {place}");

    private static string Shown(double value) => value.ToString(CultureInfo.InvariantCulture);

    private InputException BadValue(string entity, string found, string expected) =>
        Fail("bad-value", string.Create(CultureInfo.InvariantCulture, $"{entity}: {found} in group {Code}; {expected} is expected"));

    private InputException CutOff() =>
        Fail("cut-off", "the file ends before its EOF; the groups of a whole DXF file are expected: is it cut off?");

    private void NextText()
    {
        Place = _line;
        if (_at >= _bytes.Length)
        {
            throw CutOff();
        }

        var text = TextLine();
        if (!Utf8Parser.TryParse(text, out int code, out var used) || used != text.Length || code is < -5 or > 1071)
        {
            if (text.IsEmpty && _bytes.AsSpan(_at).TrimStart(" \t\r\n\x1a\0"u8).IsEmpty)
            {
                throw CutOff();
            }

            var found = DrawingLimits.Quote(Encoding.Latin1.GetString(text[..Math.Min(text.Length, 2 * DrawingLimits.MaxQuoted)]));
            throw Fail(
                Place == 1 ? "not-dxf" : "bad-group",
                $"{found}; a group code is expected, a number from 0 to 1071{(Place == 1 ? ": is this a DXF file?" : "")}");
        }

        Code = code;
        if (_at >= _bytes.Length)
        {
            throw CutOff();
        }

        text = TextLine();
        _length = text.Length;
    }

    // The line's content without blanks around it; it is also the value, unless the caller goes on to the next line.
    private ReadOnlySpan<byte> TextLine()
    {
        var rest = _bytes.AsSpan(_at);
        var length = rest.IndexOfAny((byte)'\n', (byte)'\r');
        length = length < 0 ? rest.Length : length;
        var line = rest[..length];
        var end = length + (rest[length..].StartsWith("\r\n"u8) ? 2 : length < rest.Length ? 1 : 0);
        var blanks = line.Length - line.TrimStart(" \t"u8).Length;
        _start = _at + blanks;
        _at += end;
        _line++;
        return line.Trim(" \t"u8);
    }

    private void NextBinary()
    {
        Place = _at;
        Code = _hasShortCodes && Take(1)[0] is var code and < byte.MaxValue ? code : BinaryPrimitives.ReadInt16LittleEndian(Take(2));
        switch (Code)
        {
            case >= 0 and <= 9 or >= 100 and <= 102 or 105 or >= 300 and <= 309 or >= 320 and <= 369 or >= 390 and <= 399:
            case >= 410 and <= 419 or >= 430 and <= 439 or >= 470 and <= 481 or Comment or >= 1000 and <= 1003 or >= 1005 and <= 1009:
                TakeText();
                break;
            case >= 310 and <= 319 or 1004:
                _length = Take(1)[0];
                _start = _at;
                Take(_length);
                break;
            case >= 10 and <= 59 or >= 110 and <= 149 or >= 210 and <= 239 or >= 460 and <= 469 or >= 1010 and <= 1059:
                Value(BinaryPrimitives.ReadDoubleLittleEndian(Take(8)));
                break;
            case >= 60 and <= 79 or >= 170 and <= 179 or >= 270 and <= 289 or >= 370 and <= 389 or >= 400 and <= 409:
            case >= 1060 and <= 1070:
                Value(BinaryPrimitives.ReadInt16LittleEndian(Take(2)));
                break;
            case >= 90 and <= 99 or >= 420 and <= 429 or >= 440 and <= 459 or 1071:
                Value(BinaryPrimitives.ReadInt32LittleEndian(Take(4)));
                break;
            case >= 160 and <= 169:
                Value(BinaryPrimitives.ReadInt64LittleEndian(Take(8)));
                break;
            case >= 290 and <= 299:
                Value(Take(1)[0]);
                break;
            default:
                throw Fail(
                    "bad-group",
                    string.Create(CultureInfo.InvariantCulture, $"group code {Code}; one that DXF has in binary files is expected"));
        }
    }

    private void Value(double number) => (_number, _isNumber) = (number, true);

    private void TakeText()
    {
        var length = _bytes.AsSpan(_at).IndexOf((byte)0);
        if (length < 0)
        {
            throw CutOff();
        }

        var text = _bytes.AsSpan(_at, length);
        _start = _at + length - text.TrimStart(" \t"u8).Length;
        _length = text.Trim(" \t"u8).Length;
        _at += length + 1;
    }

    private ReadOnlySpan<byte> Take(int count)
    {
        if (_bytes.Length - _at < count)
        {
            throw CutOff();
        }

        _at += count;
        return _bytes.AsSpan(_at - count, count);
    }
}
