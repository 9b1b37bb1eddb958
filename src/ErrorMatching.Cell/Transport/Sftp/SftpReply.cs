using System.Buffers.Binary;
using System.Globalization;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>A server's answer, read from its beginning to its end.</summary>
/// <param name="type">Its type.</param>
/// <param name="bytes">What follows type and number.</param>
internal sealed class SftpReply(SftpType type, byte[] bytes)
{
    private const uint HasSize = 1;
    private const uint HasOwner = 2;
    private const uint HasMode = 4;
    private const uint HasTimes = 8;
    private const uint HasMore = 0x80000000;
    private const int KindMask = 0xF000;
    private const int PlainKind = 0x8000;
    private int _at;

    /// <summary>Its type.</summary>
    public SftpType Type => type;

    /// <summary>True if nothing is left to read.</summary>
    public bool IsAtEnd => _at == bytes.Length;

    /// <summary>The next number.</summary>
    /// <exception cref="SftpLostException">The message ends before.</exception>
    public uint Number() => BinaryPrimitives.ReadUInt32BigEndian(Take(4));

    /// <summary>The next string of bytes.</summary>
    /// <exception cref="SftpLostException">The message ends before.</exception>
    public ReadOnlySpan<byte> Bytes()
    {
        var count = Number();
        return count <= bytes.Length ? Take((int)count) : throw Broken();
    }

    /// <summary>The next string as text; what is not UTF-8 becomes a replacement character.</summary>
    /// <exception cref="SftpLostException">The message ends before.</exception>
    public string Text() => Encoding.UTF8.GetString(Bytes());

    /// <summary>The next attributes: the size in bytes, null if unknown, and whether it is a plain file, true if unknown.</summary>
    /// <exception cref="SftpLostException">The message ends before.</exception>
    public (long? Size, bool IsPlain) Attributes()
    {
        var has = Number();
        long? size = (has & HasSize) != 0 ? BinaryPrimitives.ReadInt64BigEndian(Take(8)) : null;
        if ((has & HasOwner) != 0)
            Take(8);
        var isPlain = (has & HasMode) == 0 || (Number() & KindMask) is PlainKind or 0;
        if ((has & HasTimes) != 0)
            Take(8);
        for (var more = (has & HasMore) != 0 ? Number() : 0; more > 0; more--)
        {
            Bytes();
            Bytes();
        }

        return (size, isPlain);
    }

    private ReadOnlySpan<byte> Take(int count)
    {
        if (count > bytes.Length - _at)
            throw Broken();
        _at += count;
        return bytes.AsSpan(_at - count, count);
    }

    private static SftpLostException Broken() => new("the server sent a message that ends too early");
}

/// <summary>A request that an SFTP server refused.</summary>
/// <param name="code">The status.</param>
/// <param name="said">The server's own words.</param>
internal sealed class SftpStatusException(uint code, string said) : Exception(
    string.Create(CultureInfo.InvariantCulture, $"the server answered {code} ({(said.Length > 0 ? said : "no reason given")})"))
{
    /// <summary>The end of a file or of a folder's names.</summary>
    public const uint EndOfFile = 1;

    private const uint NoSuchFile = 2;
    private const uint PermissionDenied = 3;
    private const uint NoConnection = 6;
    private const uint ConnectionLost = 7;
    private const uint Unsupported = 8;

    /// <summary>The error, where the operation does not tell more.</summary>
    public TransportError Error => code switch
    {
        NoSuchFile or PermissionDenied or Unsupported => TransportError.Denied,
        NoConnection or ConnectionLost => TransportError.Away,
        _ => TransportError.Unknown,
    };

    /// <summary>True if the server gives no other reason than that it failed. Version 3 of the protocol has no code for a full disk, for
    /// example.</summary>
    public bool IsUnexplained => Error == TransportError.Unknown;
}
