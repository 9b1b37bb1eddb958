using System.Text;

namespace ErrorMatching.Measurement.Tests;

/// <summary>One measurement of two points in every format that describes itself: P1 (32.012, 5.998, 0.001) and P2 (-1.5, 20.25, -3),
/// nominal (32, 6, 0) and (-1.5, 20, -3). Between the points are characteristics that are no points.</summary>
internal static class OwnFormats
{
    public const string Qif = """
        <?xml version="1.0" encoding="UTF-8"?>
        <QIFDocument xmlns="http://qifstandards.org/xsd/qif3" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" idMax="15" versionQIF="3.0.0">
          <QPId>0fd3e7a0-1111-4222-8333-123456789abc</QPId>
          <FileUnits><PrimaryUnits><LinearUnit><SIUnitName>meter</SIUnitName><UnitName>mm</UnitName><UnitConversion><Factor>0.001</Factor></UnitConversion></LinearUnit></PrimaryUnits></FileUnits>
          <Product><PartSet n="1"><Part id="14"><ModelNumber>4711</ModelNumber></Part></PartSet></Product>
          <Features>
            <FeatureDefinitions n="2"><PointFeatureDefinition id="1"/><CircleFeatureDefinition id="2"><Diameter>8</Diameter></CircleFeatureDefinition></FeatureDefinitions>
            <FeatureNominals n="3">
              <PointFeatureNominal id="3"><FeatureDefinitionId>1</FeatureDefinitionId><Location>32 6 0</Location><Normal>0 0 1</Normal></PointFeatureNominal>
              <EdgePointFeatureNominal id="4"><FeatureDefinitionId>1</FeatureDefinitionId><Location>-1.5 20 -3</Location></EdgePointFeatureNominal>
              <CircleFeatureNominal id="5"><FeatureDefinitionId>2</FeatureDefinitionId><Location>1 2 3</Location></CircleFeatureNominal>
            </FeatureNominals>
            <FeatureItems n="3">
              <PointFeatureItem id="6"><FeatureNominalId>3</FeatureNominalId><FeatureName>P1</FeatureName></PointFeatureItem>
              <EdgePointFeatureItem id="7"><FeatureNominalId>4</FeatureNominalId><FeatureName>elsewhere</FeatureName></EdgePointFeatureItem>
              <CircleFeatureItem id="8"><FeatureNominalId>5</FeatureNominalId><FeatureName>BORE</FeatureName></CircleFeatureItem>
            </FeatureItems>
          </Features>
          <Results>
            <MeasurementResultsSet n="1">
              <MeasurementResults id="9">
                <MeasuredFeatures n="3">
                  <PointFeatureMeasurement id="10"><FeatureItemId>6</FeatureItemId><Location>32.012 5.998
                    1e-3</Location></PointFeatureMeasurement>
                  <CircleFeatureMeasurement id="11"><FeatureItemId>8</FeatureItemId><Location>1 2 3</Location><Diameter>8.01</Diameter></CircleFeatureMeasurement>
                  <EdgePointFeatureMeasurement id="12"><FeatureItemId>7</FeatureItemId><FeatureName>P2</FeatureName><Location>-1.5 20.25 -3.0</Location></EdgePointFeatureMeasurement>
                </MeasuredFeatures>
                <InspectionStatus><InspectionStatusEnum>PASS</InspectionStatusEnum></InspectionStatus>
              </MeasurementResults>
            </MeasurementResultsSet>
            <ActualComponentSets n="1"><ActualComponentSet n="1"><ActualComponent id="13"><SerialNumber>17</SerialNumber><Status><InspectionStatusEnum>PASS</InspectionStatusEnum></Status></ActualComponent></ActualComponentSet></ActualComponentSets>
          </Results>
        </QIFDocument>
        """;

    public const string Dmis = """
        $$ written by the gauge
        FILNAM/'COVER',05.2
        PN(PART)=PARTID/'4711'
        UNITS/MM,ANGDEC
        F(P1)=FEAT/POINT,CART,32.0,6.0,0.0,0.0,0.0,1.0
        OUTPUT/FA(P1),TA(XP1),TA(YP1)
        FA(P1)=FEAT/POINT,CART,32.012,5.998,$
          0.001,0.0,0.0,1.0 $$ touched once
        TA(XP1)=TOL/CORTOL,XAXIS,0.012,INTOL
        FA(BORE)=FEAT/CIRCLE,INNER,CART,1.0,2.0,3.0,0.0,0.0,1.0,8.01
        F(P2)=FEAT/POINT,CART,-1.5,20.0,-3.0,0.0,1.0,0.0
        FA(P2) = FEAT/POINT,CART,-1.5,20.25,-3.0,0.0,1.0,0.0
        FA(P1)=FEAT/POINT,CART,32.012,5.998,0.001,0.0,0.0,1.0
        ENDFIL
        """;

    public const string PcDmis = """

        DATE=26-Nov-26                       TIME=10:09:14 AM
        PART NAME  : COVER
        SER NUMBER : 17
        DIM LOC1= LOCATION OF POINT P1  UNITS=MM
        AX    NOMINAL       +TOL       -TOL       MEAS        DEV     OUTTOL
        X       32.000      0.050      0.050     32.012      0.012      0.000 -----#---
        Y        6.000      0.050      0.050      5.998     -0.002      0.000 ----#----
        Z        0.000                            0.001      0.001
        DIM LOC2= LOCATION OF PLANE PLN3  UNITS=MM
        AX    NOMINAL       +TOL       -TOL       MEAS        DEV     OUTTOL
        Z      -40.000      0.400      0.400    -40.116     -0.116      0.000 ---#-----
        FCFLOC1 = POSITION OF P2  FIT TO DATUMS=ON  UNITS=MM
        AX    NOMINAL       +TOL       -TOL      BONUS       MEAS        DEV     OUTTOL
        X       0.000                                      -0.042     -0.042
        Y       0.000                                       0.000      0.000
        DIM LOC3= LOCATION OF POINT P2  UNITS=MM
        AX    NOMINAL       +TOL       -TOL       MEAS        DEV     OUTTOL
        X       -1.500      0.050      0.050     -1.500      0.000      0.000 ----#----
        PART NUMBER=4711    DATE=26-Nov-26     TIME=10:09:15 AM           PAGE#=2
        Y       20.000      0.050      0.050     20.250      0.250      0.200 --------#
        Z       -3.000      0.050      0.050     -3.000      0.000      0.000 ----#----
        """;

    public static readonly string Aqdef = string.Join(
        "\r\n",
        "K0100 7",
        "K1001 4711",
        "K1002 Cover",
        "K2142/0 mm",
        "K2001/1 1", "K2002/1 P1.X", "K2101/1 32.000", "K2112/1 -0.05", "K2113/1 0.05",
        "K2001/2 2", "K2002/2 P1.Y", "K2101/2 6,000",
        "K2001/3 3", "K2002/3 Bore diameter", "K2101/3 8",
        "K2001/4 4", "K2002/4 P1.Z", "K2101/4 0",
        "K2001/5 P2_X", "K2101/5 -1.5",
        "K2001/6 6", "K2002/6 P2(Y)", "K2101/6 20",
        "K2001/7 7", "K2002/7 P2 z", "K2101/7 -3",
        Values("32.012 0 5,998 0 8.01 0 0.001 0 -1.5 0 20.25 0 -3 0"),
        "");

    public static readonly string Calypso = string.Join(
        "\r\n",
        "planid\tpartnb\tid\ttype\tidsymbol\tactual\tnominal\tuppertol\tlowertol\tdeviation\texceed\tfeatureid\tunit\tgroup1",
        "COVER\t17\tP1_X\txValue\tX\t32.0120000\t32.0000000\t0.0500000\t-0.0500000\t0.0120000\t\tP1\tmm\t",
        "COVER\t17\tP1_Y\tyValue\tY\t5.9980000\t6.0000000\t0.0500000\t-0.0500000\t-0.0020000\t\tP1\tmm",
        "COVER\t17\tBore\tdiameter\tD\t8.0100000\t8.0000000\t0.0500000\t-0.0500000\t0.0100000\t\tBORE\tmm",
        "COVER\t17\tP1_Z\tZ1\tzValue\t0.0010000\t0.0000000\t\t\t0.0010000\t\tP1\tmm",
        "COVER\t17\tP2_X\txValue\tX\t-1,5000000\t-1,5000000\t\t\t0,0000000\t\t\tmm",
        "COVER\t17\tP2_Y\tyValue\tY\t20.2500000\t20.0000000\t\t\t0.2500000\t\t\tmm",
        "COVER\t17\tP2_Z\tzValue\tZ\t-3.0000000\t-3.0000000\t\t\t0.0000000\t\t\tmm",
        "END",
        "");

    public static IReadOnlyDictionary<string, string> All { get; } = new SortedDictionary<string, string>(StringComparer.Ordinal)
    {
        ["part.qif"] = Qif,
        ["part.dfq"] = Aqdef,
        ["part.dmo"] = Dmis,
        ["part_chr.txt"] = Calypso,
        ["part.txt"] = PcDmis,
    };

    // Values and attributes, separated by spaces here, as a line of values.
    public static string Values(string words) => string.Join(
        '\u000f', words.Split(' ').Chunk(2).Select(pair => string.Join('\u0014', pair)));

    public static byte[] Bytes(string text) => Encoding.UTF8.GetBytes(text);
}
