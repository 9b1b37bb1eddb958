using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The system's input methods, such as for Chinese.</summary>
internal static unsafe partial class Imm32
{
    /// <summary>For <see cref="ImmGetCompositionString"/>: what is composed, its caret, and what is finished.</summary>
    public const uint Composed = 0x0008, Caret = 0x0080, Finished = 0x0800;

    /// <summary>Kinds of <see cref="Form"/>: at a point, and outside of a rectangle.</summary>
    public const uint AtPoint = 0x0002, Outside = 0x0080;

    /// <summary>For <see cref="ImmNotify"/>: ends a composition without its text.</summary>
    public const uint EndsComposition = 0x15, Cancel = 4;

    private const string Library = "imm32";

    [LibraryImport(Library)] public static partial nint ImmGetContext(nint window);
    [LibraryImport(Library)] public static partial int ImmReleaseContext(nint window, nint context);
    [LibraryImport(Library)] public static partial int ImmAssociateContextEx(nint window, nint context, uint flags);
    [LibraryImport(Library)] public static partial int ImmSetCompositionWindow(nint context, Form* form);
    [LibraryImport(Library)] public static partial int ImmSetCandidateWindow(nint context, CandidateForm* form);
    [LibraryImport(Library, EntryPoint = "ImmGetCompositionStringW")]
    public static partial int ImmGetCompositionString(nint context, uint what, void* buffer, uint bytes);
    [LibraryImport(Library, EntryPoint = "ImmNotifyIME")]
    public static partial int ImmNotify(nint context, uint action, uint index, uint value);

    /// <summary>COMPOSITIONFORM.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Form
    {
        public uint Kind;
        public User32.Pixel At;
        public User32.Rect Area;
    }

    /// <summary>CANDIDATEFORM.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct CandidateForm
    {
        public uint Index, Kind;
        public User32.Pixel At;
        public User32.Rect Area;
    }
}
