using System.Buffers.Binary;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>A message to an SFTP server, version 3 of the protocol (draft-ietf-secsh-filexfer-02).</summary>
internal sealed class SftpRequest
{
    private const int Header = 4 + 1 + 4;
    private byte[] _bytes = new byte[256];

    /// <summary>Begins a request.</summary>
    public SftpRequest(SftpType type)
    {
        _bytes[4] = (byte)type;
        Count = Header;
    }

    /// <summary>Number of bytes so far.</summary>
    public int Count { get; private set; }

    /// <summary>The first message of a session, the only one without a number.</summary>
    public static byte[] Init(uint version)
    {
        var bytes = new byte[] { 0, 0, 0, 5, (byte)SftpType.Init, 0, 0, 0, 0 };
        BinaryPrimitives.WriteUInt32BigEndian(bytes.AsSpan(5), version);
        return bytes;
    }

    /// <summary>Adds a number.</summary>
    public SftpRequest Add(uint number)
    {
        BinaryPrimitives.WriteUInt32BigEndian(Room(4), number);
        return this;
    }

    /// <summary>Adds a place in a file.</summary>
    public SftpRequest Add(long offset)
    {
        BinaryPrimitives.WriteInt64BigEndian(Room(8), offset);
        return this;
    }

    /// <summary>Adds a string of bytes, such as a handle or the content of a file.</summary>
    public SftpRequest Add(ReadOnlySpan<byte> bytes)
    {
        Add((uint)bytes.Length);
        bytes.CopyTo(Room(bytes.Length));
        return this;
    }

    /// <summary>Adds a path or a name, in UTF-8.</summary>
    public SftpRequest Add(string text) => Add(Encoding.UTF8.GetBytes(text));

    /// <summary>The message with its length and its number.</summary>
    public byte[] Numbered(uint id)
    {
        BinaryPrimitives.WriteInt32BigEndian(_bytes, Count - 4);
        BinaryPrimitives.WriteUInt32BigEndian(_bytes.AsSpan(5), id);
        return _bytes;
    }

    private Span<byte> Room(int count)
    {
        if (Count + count > _bytes.Length)
            Array.Resize(ref _bytes, Math.Max(2 * _bytes.Length, Count + count));
        Count += count;
        return _bytes.AsSpan(Count - count, count);
    }
}

/// <summary>The types of messages that are used.</summary>
internal enum SftpType
{
    Init = 1,
    Version = 2,
    Open = 3,
    Close = 4,
    Read = 5,
    Write = 6,
    LStat = 7,
    OpenFolder = 11,
    ReadFolder = 12,
    Remove = 13,
    RealPath = 16,
    Rename = 18,
    Status = 101,
    Handle = 102,
    Data = 103,
    Name = 104,
    Attributes = 105,
    Extended = 200,
}
